// A broken edit costs nobody the picture: it stays, marked as stale, with the reason at the author's line.
#include "support/in_a_window.h"

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// What is broken, and where that is said to be.
struct Breach {
    const char* name;
    std::string input;
    std::string file;   // that is edited
    std::string good;   // green
    std::string broken; // "" the file is deleted
    std::string mended; // blue
    std::map<std::string, std::string> others;
    int line; // 0: none can be named

    friend void PrintTo(const Breach& breach, std::ostream* out)
    {
        *out << breach.name;
    }
};

std::string skyOf(const Paint& paint)
{
    const std::string colour = "[" + paint.vector() + "]";
    return "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\n[sky]\ngradient = [" + colour + ", " + colour +
           ", " + colour + "]\n[[sphere]]\ncentre = [0, 0, 50]\nradius = 1\n";
}

const std::string broken =
    "void mainImage(out vec4 colour, in vec2 pixel)\n{\n    colour = vec4(nothing, 1.0);\n}\n";
const std::string caller =
    "#include \"paint.glsl\"\nvoid mainImage(out vec4 c, in vec2 p)\n{\n    c = paint();\n}\n";

std::string paintOf(const Paint& paint)
{
    return "vec4 paint() { return vec4(" + paint.vector() + ", 1.0); }\n";
}

class AFault : public InAWindow, public testing::WithParamInterface<Breach>
{
};
class AFirstFault : public AFault
{
};

const auto nameOf = [](const auto& info) { return std::string(info.param.name); };

const std::vector<Breach> breaches{
    Breach{"BrokenShader", "a.frag", "a.frag", green.shader(), broken, blue.shader(), {}, 3},
    Breach{"BrokenInclude",
           "a.frag",
           "paint.glsl",
           paintOf(green),
           "\nvec4 paint() { return 1; }\n",
           paintOf(blue),
           {{"a.frag", caller}},
           2},
    Breach{"FunctionEditedAway",
           "a.frag",
           "paint.glsl",
           paintOf(green),
           "\n",
           paintOf(blue),
           {{"a.frag", caller}},
           4},
    Breach{"BrokenToml", "a.toml", "a.toml", skyOf(green), "[camera]\neye = [0, 0\n", skyOf(blue), {}, 2},
    Breach{"UnknownKey", "a.toml", "a.toml", skyOf(green), "[camera]\nlens = 3\n", skyOf(blue), {}, 2},
    Breach{"MissingPicture",
           "a.toml",
           "a.toml",
           skyOf(green),
           "[camera]\n[sky]\nimage = \"none.png\"\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n",
           skyOf(blue),
           {},
           3}};
// A file that was never there, and one without a picture yet, are no matter of an edit.
const std::vector<Breach> laterBreaches{
    Breach{
        "IncludeDeleted", "a.frag", "paint.glsl", paintOf(green), "", paintOf(blue), {{"a.frag", caller}}, 1},
    Breach{"EmptyShader", "a.frag", "a.frag", green.shader(), "\n", blue.shader(), {}, 0}};

INSTANTIATE_TEST_SUITE_P(Breaches, AFault, testing::ValuesIn(breaches), nameOf);
INSTANTIATE_TEST_SUITE_P(LaterBreaches, AFault, testing::ValuesIn(laterBreaches), nameOf);
INSTANTIATE_TEST_SUITE_P(Breaches, AFirstFault, testing::ValuesIn(breaches), nameOf);

} // namespace

TEST_P(AFault, KeepsThePictureMarked_TellsWhere_AndGoesWithTheMend)
{
    const Breach& breach = GetParam();
    for (const auto& [name, text] : breach.others)
        save(folder / name, text);
    save(folder / breach.file, breach.good);
    open({breach.input, "--spp", "1"});
    ASSERT_TRUE(becomes(green));

    if (breach.broken.empty())
        std::filesystem::remove(folder / breach.file);
    else
        save(folder / breach.file, breach.broken);
    const auto event = program->next("error");
    EXPECT_TRUE(eventually([&] { return isStaleOver(green); }));
    if (breach.line > 0) {
        ASSERT_FALSE(event["places"].empty()) << event;
        const auto& place = event["places"][0];
        EXPECT_EQ(place["line"], breach.line) << event;
        EXPECT_GT(place["column"].get<int>(), 0) << event;
        const std::string where = place["path"].get<std::string>() + ":" + std::to_string(breach.line) + ":" +
                                  std::to_string(place["column"].get<int>()) + ":";
        EXPECT_NE(program->error().find(where), std::string::npos) << program->error();
    }

    save(folder / breach.file, breach.mended);
    program->next("shown");
    EXPECT_TRUE(becomes(blue));
    EXPECT_NE(program->error().find("dioptre: mended"), std::string::npos);
}

// There is no picture to keep: the words alone, until the mend.
TEST_P(AFirstFault, IsShownInTheWindow_UntilTheMend)
{
    const Breach& breach = GetParam();
    for (const auto& [name, text] : breach.others)
        save(folder / name, text);
    save(folder / breach.file, breach.broken);
    start({breach.input, "--spp", "1"});
    program->next("error");
    const auto redPixels = [&] {
        const Picture seen = hand->see();
        int count = 0;
        for (int y = 0; y < height / 2; ++y)
            for (int x = 0; x < width; ++x) {
                const Rgb pixel = pixelOf(seen, x, y);
                count += pixel.red > 150 && pixel.green < 130 ? 1 : 0;
            }
        return count;
    };
    EXPECT_TRUE(eventually([&] { return redPixels() > 100; })) << "no words in red";
    save(folder / breach.file, breach.mended);
    EXPECT_TRUE(becomes(blue));
}
