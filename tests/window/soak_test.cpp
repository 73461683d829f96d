// A day of edits: whatever is saved, the window lives, leaks nothing, and shows the last good picture.
#include "base/file.h"
#include "support/in_a_window.h"

#include <cstdlib>
#include <random>
#include <sys/prctl.h>
#include <thread>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

constexpr unsigned seed = 20240607;

std::string sceneText(double radius, bool mirrored, int size = 1)
{
    std::string text =
        "[camera]\neye = [0, 0, 6]\ntarget = [0, 0, 0]\n[sky]\nimage = \"sky.png\"\n[material.m]\n"
        "colour = [0.8, 0.4, 0.2]\n" +
        std::string(mirrored ? "mirror = 0.5\n" : "") +
        "[[light]]\nkind = \"ambient\"\nambient = [0.6, 0.6, 0.6]\n";
    for (int i = 0; i < size; ++i)
        text += "[[sphere]]\ncentre = [" + std::to_string(i) + ", 0, 0]\nradius = " + std::to_string(radius) +
                "\nmaterial = \"m\"\n";
    return text;
}

std::string shaderText(double share)
{
    return "#include \"curve.glsl\"\nvoid mainImage(out vec4 c, in vec2 p)\n{\n    c = vec4(curve(p.x / "
           "iResolution.x), " +
           std::to_string(share) + ", texture(iChannel0, vec2(0.5)).b, 1.0);\n}\n";
}

std::string curveText(double power)
{
    return "float curve(float x) { return pow(x, " + std::to_string(power) + "); }\n";
}

void writeSky(const std::filesystem::path& file, int blue)
{
    Picture picture{8, 4, PixelFormat::srgb8, {}, {}};
    for (int i = 0; i < 32; ++i)
        picture.bytes.insert(picture.bytes.end(),
                             {static_cast<std::uint8_t>(8 * i), 90, static_cast<std::uint8_t>(blue), 255});
    const std::filesystem::path other = file.string() + "~.png";
    writePng(other, picture, {}, {});
    std::filesystem::rename(other, file);
}

// The edits of one input, good and bad, by one who never looks up.
class Editor
{
public:
    Editor(const std::filesystem::path& folder, bool isScene) : folder_(folder), isScene_(isScene) {}

    void good()
    {
        save(input(), isScene_ ? sceneText(1.0, true) : shaderText(0.25));
        save(folder_ / "curve.glsl", curveText(2.0));
        writeSky(folder_ / "sky.png", 200);
    }

    void edit()
    {
        switch (number(10)) {
        case 0:
            return replace(input(), someGood());
        case 1:
            return save(input(), someGood() + "nonsense = \n");
        case 2: // cut in the middle of a save, whose writer goes on a moment later
            save(input(), someGood().substr(0, 60));
            return save(input(), someGood());
        case 3:
            std::filesystem::remove(input());
            return;
        case 4: { // renamed away and back
            std::error_code ignored;
            std::filesystem::rename(input(), folder_ / "away", ignored);
            std::filesystem::rename(folder_ / "away", input(), ignored);
            return;
        }
        case 5:
            return save(folder_ / "curve.glsl", number(3) == 0 ? "float curve(float x) { for (;;) {} }\n"
                                                               : curveText(1.0 + number(5)));
        case 6:
            return save(input(), isScene_ ? sceneText(1.0, number(2) == 0, 1 + number(3)) : "int a[;\n");
        case 7:
            return writeSky(folder_ / "sky.png", 20 * number(12));
        case 8:
            return save(folder_ / "sky.png", "no picture");
        default:
            return save(input(), someGood());
        }
    }

    int number(int below)
    {
        return std::uniform_int_distribution<int>(0, below - 1)(random_);
    }

private:
    std::filesystem::path input() const
    {
        return folder_ / (isScene_ ? "a.toml" : "a.frag");
    }
    std::string someGood()
    {
        const double share = number(100) / 100.0;
        return isScene_ ? sceneText(0.5 + share, number(4) == 0) : shaderText(share);
    }

    std::filesystem::path folder_;
    bool isScene_;
    std::mt19937 random_{seed};
};

class Soak : public InAWindow, public testing::WithParamInterface<bool>
{
protected:
    // The window inherits it. Heaps are counted in small pages: in large ones a byte more may be 2 MiB more.
    Soak()
    {
        ::prctl(PR_SET_THP_DISABLE, 1, 0, 0, 0);
    }

    // Of each of the two. $DIOPTRE_SOAK: as many as its user has patience for.
    int edits() const
    {
        if (const char* many = std::getenv("DIOPTRE_SOAK"))
            return std::stoi(many);
        const char* full = std::getenv("DIOPTRE_FULL");
        return full != nullptr && std::string(full) == "yes" ? 1000 : 25;
    }

    // The good picture again, whatever was edited before; as it was told when its last sample was done.
    LiveProcess::Json goodPicture(Editor& editor)
    {
        // A mark of its own, so that its event cannot be one of an edit before.
        eventually([&] {
            program->forget();
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            return !program->nextIfThere("shown");
        });
        save(folder / "curve.glsl", "broken");
        save(folder / "sky.png", "broken");
        program->next("error");
        editor.good();
        EXPECT_TRUE(eventually([&] { return isAsRendered(); })) << program->error().substr(0, 2000);
        std::this_thread::sleep_for(std::chrono::milliseconds(300));
        LiveProcess::Json last;
        while (auto event = program->nextIfThere("done"))
            last = *event;
        return last;
    }

    bool isAsRendered() const
    {
        const Picture seen = hand->see();
        int largest = seen.bytes.size() == still.bytes.size() ? 0 : 255;
        for (std::size_t i = 0; largest < 255 && i < seen.bytes.size(); ++i)
            largest = std::max(largest, std::abs(seen.bytes[i] - still.bytes[i]));
        return largest <= 1; // the window encodes on the device, a still on the CPU
    }

    Picture still;
};
INSTANTIATE_TEST_SUITE_P(Inputs, Soak, testing::Values(true, false),
                         [](const auto& info) { return info.param ? "Scene" : "Shader"; });

} // namespace

// Resident memory is that of the window's process alone, while the good picture stands finished: what the
// picture needs is the same each time. It is compared from a quarter of the edits on, by when the heap's
// arenas, the driver's pools and its caches have grown to what such edits need; a leak would go on growing.
TEST_P(Soak, AnyEdits_LeakNothingAndEndWithTheRightPicture)
{
    std::cout << "seed " << seed << ", " << edits() << " edits\n";
    Editor editor(folder, GetParam());
    editor.good();
    const std::string words = GetParam() ? "a.toml --spp 2" : "a.frag --channel0 sky.png";
    ASSERT_EQ(here("dioptre render " + words + " --size 200x160 -o still.png").code, 0);
    still = readPicture(folder / "still.png");
    if (GetParam())
        open({"a.toml", "--spp", "2", "--draw-limit", "1"});
    else
        open({"a.frag", "--channel0", "sky.png", "--draw-limit", "1"});
    const auto first = goodPicture(editor);
    double quarter_mib = 0.0;
    for (int i = 0; i < edits(); ++i) {
        editor.edit();
        // Some come as fast as they can, most a moment later, and some are let finish.
        const int pause_ms =
            std::vector<int>{0, 0, 5, 20, 60, 150, 400}[static_cast<std::size_t>(editor.number(7))];
        std::this_thread::sleep_for(std::chrono::milliseconds(pause_ms));
        program->forget();
        if ((i + 1) % std::max(1, edits() / 8) == 0) {
            const auto event = goodPicture(editor);
            std::cout << i + 1 << ": " << program->resident_mib() << " MiB, " << event["gl_objects"]
                      << " GL objects\n"
                      << std::flush;
            if (i + 1 <= edits() / 4)
                quarter_mib = program->resident_mib();
        }
        ASSERT_TRUE(isRunning(program->id()))
            << "after edit " << i << ", exit code " << program->ended() << "\n"
            << program->error();
    }
    const auto last = goodPicture(editor);
    const double end_mib = program->resident_mib();
    EXPECT_EQ(last["gl_objects"], first["gl_objects"]);
    std::cout << "resident: " << quarter_mib << " MiB after a quarter, " << end_mib << " at the end\n";
    // A few edits do not come to where memory stands still: they are held to a bound that a leak of a picture
    // an edit would break.
    EXPECT_LT(end_mib, (edits() >= 500 ? 1.01 : 1.05) * quarter_mib);
    hand->tap("q", {"Control_L"});
    EXPECT_EQ(program->ended(), 0) << program->error();
}
