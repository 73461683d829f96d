// Whatever a picture is made of: once it is saved, the window shows it, however editors save.
#include "base/file.h"
#include "support/in_a_window.h"

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// A picture of one colour as a file.
void writePaint(const std::filesystem::path& file, const Paint& paint)
{
    Picture picture{4, 2, PixelFormat::srgb8, {}, {}};
    for (int i = 0; i < 8; ++i)
        picture.bytes.insert(picture.bytes.end(), {static_cast<std::uint8_t>(paint.rgb.red),
                                                   static_cast<std::uint8_t>(paint.rgb.green),
                                                   static_cast<std::uint8_t>(paint.rgb.blue), 255});
    writePng(file, picture, {}, {});
}

std::string pictureText(const Paint& paint)
{
    const auto file =
        std::filesystem::temp_directory_path() / ("dioptre-paint-" + std::to_string(::getpid()));
    writePaint(file, paint);
    std::string text = readFile(file);
    std::filesystem::remove(file);
    return text;
}

// Nothing but its sky can be seen.
std::string skyScene(const std::string& sky)
{
    return "[camera]\neye = [0, 0, 0]\ntarget = [0, 0, -1]\nfov_y_deg = 60\n[sky]\n" + sky +
           "\n[[sphere]]\ncentre = [0, 0, 50]\nradius = 1\n";
}

std::string sceneText(const Paint& paint)
{
    const std::string colour = "[" + paint.vector() + "]";
    return skyScene("gradient = [" + colour + ", " + colour + ", " + colour + "]");
}

// What is edited, and what the window is opened with.
struct Part {
    const char* name;
    std::string file;                        // that is edited
    std::string (*text)(const Paint& paint); // of it
    std::map<std::string, std::string> others;
    std::vector<std::string> words;

    friend void PrintTo(const Part& part, std::ostream* out)
    {
        *out << part.name;
    }
};

const std::string throughChannel =
    "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p / iResolution.xy); }\n";

std::vector<Part> parts()
{
    return {{"Shader", "a.frag", [](const Paint& paint) { return paint.shader(); }, {}, {"a.frag"}},
            {"IncludeOfAnInclude",
             "deep.glsl",
             [](const Paint& paint) { return "vec3 paint() { return vec3(" + paint.vector() + "); }\n"; },
             {{"a.frag", "#include \"near.glsl\"\nvoid mainImage(out vec4 c, in vec2 p) { c = near(); }\n"},
              {"near.glsl", "#include \"deep.glsl\"\nvec4 near() { return vec4(paint(), 1.0); }\n"}},
             {"a.frag"}},
            {"Scene", "a.toml", sceneText, {}, {"a.toml", "--spp", "2"}},
            {"ChannelOfAShader",
             "a.png",
             pictureText,
             {{"a.frag", throughChannel}},
             {"a.frag", "--channel0", "a.png"}},
            {"PictureOfAScene",
             "a.png",
             pictureText,
             {{"a.toml", skyScene("image = \"a.png\"")}},
             {"a.toml", "--spp", "2"}},
            {"PictureByItself", "a.png", pictureText, {}, {"a.png", "--size", "4x2"}}};
}

class Reload : public InAWindow, public testing::WithParamInterface<Part>
{
};

INSTANTIATE_TEST_SUITE_P(Parts, Reload, testing::ValuesIn(parts()),
                         [](const auto& info) { return std::string(info.param.name); });

} // namespace

TEST_P(Reload, EverySave_ShowsTheLast)
{
    const Part& part = GetParam();
    const auto file = folder / part.file;
    for (const auto& [name, text] : part.others)
        save(folder / name, text);
    save(file, part.text(green));
    open(part.words);
    ASSERT_TRUE(becomes(green));

    save(file, part.text(blue));
    EXPECT_TRUE(becomes(blue)) << "saved in place";

    replace(file, part.text(white));
    EXPECT_TRUE(becomes(white)) << "replaced by another file";

    // Of one size and within one second: neither length nor a coarse clock tells them apart.
    save(file, part.text(yellow));
    EXPECT_TRUE(becomes(yellow));
    save(file, part.text(cyan));
    EXPECT_TRUE(becomes(cyan)) << "saved again at once";

    for (const Paint* paint : {&green, &blue, &white, &yellow, &cyan, &green, &white, &magenta})
        paint->letter % 2 == 0 ? save(file, part.text(*paint)) : replace(file, part.text(*paint));
    EXPECT_TRUE(becomes(magenta)) << "the last of a burst";
    EXPECT_EQ(isRunning(program->id()), true);

    std::filesystem::remove(file);
    program->next("error");
    if (hand->size().second == height) {
        EXPECT_TRUE(eventually([&] { return isStaleOver(magenta); })) << "gone";
    }
    save(file, part.text(green));
    EXPECT_TRUE(becomes(green)) << "there again";
    hand->tap("q", {"Control_L"});
    EXPECT_EQ(program->ended(), 0) << program->error();
}
