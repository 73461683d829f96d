// A fixture for tests that drive a window of `dioptre live`.
#pragma once

#include "support/display.h"
#include "support/in_a_folder.h"
#include "support/live_process.h"
#include "support/x_driver.h"

#include <fstream>
#include <memory>

namespace dioptre::test
{

// Writes the file where it stands, as a shell does.
inline void save(const std::filesystem::path& file, const std::string& text)
{
    std::ofstream(file, std::ios::trunc | std::ios::binary) << text;
}

// Writes another file and gives it this name, as most editors do.
inline void replace(const std::filesystem::path& file, const std::string& text)
{
    const std::filesystem::path other = file.string() + "~";
    save(other, text);
    std::filesystem::rename(other, file);
}

// A plain shader of one colour, and a picture of one in the window.
struct Paint {
    Rgb rgb;     // 0 or 255 each: no encoding moves them
    char letter; // for names
    std::string vector() const
    {
        const auto share = [](int number) { return number > 0 ? std::string("1.0") : std::string("0.0"); };
        return share(rgb.red) + ", " + share(rgb.green) + ", " + share(rgb.blue);
    }
    std::string shader() const
    {
        return "void mainImage(out vec4 colour, in vec2 pixel)\n{\n    colour = vec4(" + vector() +
               ", 1.0);\n}\n";
    }
};

inline const Paint green{{0, 255, 0}, 'g'}, blue{{0, 0, 255}, 'b'}, white{{255, 255, 255}, 'w'},
    yellow{{255, 255, 0}, 'y'}, cyan{{0, 255, 255}, 'c'}, magenta{{255, 0, 255}, 'm'};

// A scene of which every part of the picture changes with the camera.
inline const std::string oneBall = R"([camera]
eye = [0.0, 1.0, 6.0]
target = [0.0, 0.0, 0.0]
fov_y_deg = 40.0
[sky]
gradient = [[0.1, 0.1, 0.2], [0.3, 0.3, 0.4], [0.2, 0.4, 0.8]]
[[light]]
kind = "ambient"
ambient = [0.3, 0.3, 0.3]
[[sphere]]
centre = [1.0, 0.0, 0.0]
radius = 1.0
)";

// The program, its window, and a user's hand on it. Windows are small, so that a software renderer is done
// with them at once; a place is left that no overlay but the help reaches.
class InAWindow : public InAFolder
{
protected:
    static constexpr int width = 200, height = 160;          // pixels, where a test says nothing else
    static constexpr std::pair<int, int> freePlace{100, 90}; // from the lower left
    static constexpr std::pair<int, int> border{3, 90};      // where a stale picture has its frame
    static constexpr Rgb frameRed{235, 60, 50};              // of that frame

    InAWindow()
    {
        environment = {{"DISPLAY", display().name()},
                       {"DIOPTRE_CACHE", "off"},
                       {"XDG_STATE_HOME", (folder / "state").string()}};
    }

    // One server for all tests of a program, ended with it.
    static const VirtualDisplay& display()
    {
        static const VirtualDisplay shared;
        return shared;
    }

    // Starts it, and waits for the window alone.
    void start(const std::vector<std::string>& words)
    {
        std::vector<std::string> all = usualWords;
        if (!all.empty() && std::ranges::find(words, "--size") == words.end())
            all.insert(all.end(), {"--size", std::to_string(width) + "x" + std::to_string(height)});
        all.insert(all.end(), words.begin(), words.end());
        hand.reset();
        program.reset();
        program.emplace(folder, all, environment);
        try {
            hand.emplace(environment.at("DISPLAY"),
                         "dioptre live: ", [this] { return !isRunning(program->id()); });
        } catch (const std::runtime_error& error) {
            throw std::runtime_error(error.what() + ("; it said\n" + program->error()));
        }
        hand->moveTo(width / 2, height / 2);
    }

    // Waits for the first picture as well.
    LiveProcess::Json open(const std::vector<std::string>& words)
    {
        start(words);
        return program->next("shown");
    }

    Rgb at(std::pair<int, int> place) const
    {
        return pixelOf(hand->see(), place.first, place.second);
    }

    // Every pixel of the window, so that nothing lies over the picture.
    bool isAll(const Paint& paint) const
    {
        const Picture seen = hand->see();
        for (int y = 0; y < seen.height; ++y)
            for (int x = 0; x < seen.width; ++x)
                if (!(pixelOf(seen, x, y) == paint.rgb))
                    return false;
        return true;
    }
    bool becomes(const Paint& paint, double limit_s = 30.0) const
    {
        return eventually([&] { return isAll(paint); }, limit_s);
    }

    // The window's pixels once they stand still.
    Picture settled() const
    {
        Picture last = hand->see();
        int same = 0;
        eventually([&] {
            Picture now = hand->see();
            same = now.bytes == last.bytes && now.width == last.width ? same + 1 : 0;
            last = std::move(now);
            return same > 15;
        });
        return last;
    }
    bool changesFrom(const Picture& before, double limit_s = 30.0) const
    {
        return eventually([&] { return hand->see().bytes != before.bytes; }, limit_s);
    }

    // The red frame of a picture that is not that of the files, and at the free place that picture.
    bool isStaleOver(const Paint& paint) const
    {
        const Picture seen = hand->see();
        return pixelOf(seen, border.first, border.second) == frameRed &&
               pixelOf(seen, freePlace.first, freePlace.second) == paint.rgb;
    }

    std::vector<std::string> usualWords{"--forget", "--no-panel"}; // without any, no size is given either
    std::map<std::string, std::string> environment;
    std::optional<LiveProcess> program;
    std::optional<XDriver> hand;
};

} // namespace dioptre::test
