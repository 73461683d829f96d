// What a window opens: by the words that `dioptre render` takes as well, or by a file that is dropped in.
#include "base/file.h"
#include "support/compare.h"
#include "support/in_a_window.h"
#include "support/x_drop.h"

using namespace dioptre;
using namespace dioptre::test;

namespace
{

const std::string ball = "[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\n[sky]\ngradient = [[0.2, 0.2, 0.2], "
                         "[0.5, 0.4, 0.3], [0.1, 0.2, 0.6]]\n";
const std::string lights = "[[light]]\nkind = \"ambient\"\nambient = [0.4, 0.4, 0.4]\n[[light]]\nkind = "
                           "\"point\"\nposition = [2, 2, 4]\ndiffuse = [0.6, 0.6, 0.6]\n";
const std::string scene = ball + lights + "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";

// Words after the input, for both commands alike.
struct Words {
    const char* name;
    std::string input;
    std::vector<std::string> words;

    friend void PrintTo(const Words& words, std::ostream* out)
    {
        *out << words.name;
    }
};

class Open : public InAWindow
{
protected:
    Open()
    {
        save(folder / "a.toml", scene);
        save(folder / "a.frag",
             "uniform float u_share; // 0.25\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(u_share, p / "
             "iResolution.xy, 1.0); }\n");
        std::filesystem::create_directory(folder / "other");
        save(folder / "other" / "paint.glsl", "vec4 paint() { return vec4(0.2, 0.4, 0.6, 1.0); }\n");
        save(folder / "b.frag", "#include \"paint.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = "
                                "paint() * p.x / 200.0; }\n");
        save(folder / "c.frag",
             "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }\n");
        Picture picture{
            2, 2, PixelFormat::srgb8, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 90, 90, 90, 255}, {}};
        writePng(folder / "a.png", picture, {}, {});
    }

    // The window's pixels against a still of the command line, in steps of 255.
    void expectAsRendered(const std::string& input, const std::vector<std::string>& words,
                          int width_px = width, int height_px = height) const
    {
        std::string command = "dioptre render " + input + " -o still.png --size " + std::to_string(width_px) +
                              "x" + std::to_string(height_px);
        for (const auto& word : words)
            command += " '" + word + "'";
        const auto outcome = here(command);
        ASSERT_EQ(outcome.code, 0) << outcome.error;
        const Picture seen = settled(), still = readPicture(folder / "still.png");
        ASSERT_EQ(std::pair(seen.width, seen.height), std::pair(still.width, still.height));
        int largest = 0; // the window encodes on the device, a still on the CPU
        for (std::size_t i = 0; i < seen.bytes.size(); ++i)
            largest = std::max(largest, std::abs(seen.bytes[i] - still.bytes[i]));
        EXPECT_LE(largest, 1);
    }
};

class Option : public Open, public testing::WithParamInterface<Words>
{
};
INSTANTIATE_TEST_SUITE_P(
    Words, Option,
    testing::Values(Words{"Scene", "a.toml", {"--spp", "3"}},
                    Words{"SetOfAScene", "a.toml", {"--spp", "2", "--set", "sphere.0.radius=0.5"}},
                    Words{"SetOfAShader", "a.frag", {"--set", "u_share=0.75"}},
                    Words{"Include", "b.frag", {"--include", "other"}},
                    Words{"Channel", "c.frag", {"--channel0", "a.png"}},
                    Words{"View", "a.toml", {"--spp", "2", "--view", "normal"}},
                    Words{"Gallery", "spheres", {"--spp", "2"}}),
    [](const auto& info) { return std::string(info.param.name); });

} // namespace

TEST_P(Option, IsAsInRender)
{
    std::vector<std::string> words{GetParam().input};
    words.insert(words.end(), GetParam().words.begin(), GetParam().words.end());
    open(words);
    program->next("done");
    expectAsRendered(GetParam().input, GetParam().words);
}

TEST_F(Open, Resize_DrawsThePictureInTheWindowsSize)
{
    open({"a.toml", "--spp", "2"});
    program->next("done");
    for (const auto& [wide, high] :
         {std::pair{310, 150}, std::pair{90, 201}, std::pair{1, 1}, std::pair{200, 160}}) {
        hand->resize(wide, high);
        EXPECT_TRUE(eventually([&, w = wide, h = high] { return hand->size() == std::pair(w, h); }));
        program->next("done");
        expectAsRendered("a.toml", {"--spp", "2"}, wide, high);
    }
}

TEST_F(Open, DroppedFile_IsOpened)
{
    open({"a.toml", "--spp", "2"});
    program->next("done");
    for (const std::string file : {"a.frag", "a.toml", "a.png", "a.frag"}) {
        drop(*hand, {folder / file});
        EXPECT_EQ(program->next("opened")["input"], (folder / file).string());
        program->next("done");
        EXPECT_NE(hand->title().find(file.substr(0, 1)), std::string::npos);
        if (file != "a.png")
            expectAsRendered(file, {"--spp", "2"});
        else
            EXPECT_EQ(pixelOf(settled(), 99, 79), (Rgb{255, 0, 0})) << "its lower left, in the middle";
        save(folder / "a.frag", readFile(folder / "a.frag") + " ");
    }
    // It is watched as well.
    save(folder / "a.frag", green.shader());
    EXPECT_TRUE(becomes(green));
}

TEST_F(Open, DroppedNonsense_KeepsThePictureAndSaysWhy)
{
    save(folder / "g.frag", green.shader());
    open({"g.frag"});
    ASSERT_TRUE(becomes(green));
    save(folder / "notes.txt", "nothing of the kind\n");
    save(folder / "bad.png", "no picture\n");
    for (const std::string file : {"notes.txt", "none.toml", "bad.png"}) {
        drop(*hand, {folder / file});
        const auto event = program->next("error");
        EXPECT_NE(event["text"].get<std::string>().find(file), std::string::npos) << event;
        // What cannot be opened at all leaves the picture as good as it was.
        EXPECT_EQ(event["stale"].get<bool>(), file == "bad.png") << event;
        if (file == "bad.png") {
            EXPECT_TRUE(eventually([&] { return isStaleOver(green); })) << file;
        }
    }
    drop(*hand, {folder / "g.frag"});
    EXPECT_TRUE(becomes(green));
}

// A number is fed to the program that is there; a part of the tracer that was left out is compiled in, and
// stays for the next time.
TEST_F(Open, Values_CompileNothing_FeaturesOnce)
{
    const auto text = [](const std::string& mirror, const std::string& colour) {
        return ball + lights + "[material.m]\nmirror = " + mirror + "\ncolour = " + colour +
               "\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
    };
    save(folder / "a.toml", text("0.0", "[0.9, 0.9, 0.9]"));
    open({"a.toml", "--spp", "2"});
    program->next("done");
    const auto edit = [&](const std::string& mirror, const std::string& colour) {
        save(folder / "a.toml", text(mirror, colour));
        const bool compiled = program->next("shown")["compiled"];
        program->next("done");
        return compiled;
    };
    const Picture first = settled();
    EXPECT_FALSE(edit("0.0", "[0.2, 0.5, 0.9]")) << "a colour";
    EXPECT_TRUE(changesFrom(first));
    EXPECT_TRUE(edit("0.5", "[0.9, 0.9, 0.9]")) << "the first mirror";
    const Picture mirrored = settled();
    EXPECT_NE(mirrored.bytes, first.bytes);
    EXPECT_FALSE(edit("0.0", "[0.9, 0.9, 0.9]")) << "none";
    expectAsRendered("a.toml", {"--spp", "2"});
    EXPECT_FALSE(edit("0.5", "[0.9, 0.9, 0.9]")) << "a mirror again";
    EXPECT_EQ(settled().bytes, mirrored.bytes);
}
