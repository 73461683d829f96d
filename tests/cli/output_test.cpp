// How the picture is written: kinds of file, bits, exposure, curve, encoding, layers.
#include "base/file.h"
#include "base/srgb.h"
#include "support/compare.h"
#include "support/in_a_folder.h"

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfStringAttribute.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

using namespace dioptre;
using dioptre::test::run;

namespace
{

// A sky of one radiance in each channel, and nothing else: 0.18, 1 and 4.
class OutputOptions : public test::InAFolder
{
protected:
    OutputOptions()
    {
        here("printf '[sky]\\ncolour = [0.18, 1, 4]\\n' >sky.toml");
        here("printf 'out vec4 o;\\nvoid main()\\n{\\n    o = vec4(0.3);\\n}\\n' >plain.frag");
    }

    // The first texel of the sky, 16 bits a channel, in 0..1 as encoded.
    std::array<double, 3> encoded(const std::string& options)
    {
        const auto outcome =
            here("dioptre render sky.toml --size 4x2 --spp 1 --depth 16 -o a.png " + options);
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        const auto picture = readPicture(folder / "a.png", Encoding::linear); // as the file has them
        return {picture.floats[0], picture.floats[1], picture.floats[2]};
    }

    void expectRefused(const std::string& command, const std::vector<std::string>& words)
    {
        const auto outcome = here(command);
        EXPECT_EQ(outcome.code, 2) << command;
        for (const auto& word : words)
            EXPECT_NE(outcome.error.find(word), std::string::npos) << word << " not in " << outcome.error;
        for (const char* kind : {"a.png", "a.exr", "a.hdr"})
            EXPECT_FALSE(std::filesystem::exists(folder / kind)) << command;
    }
};

constexpr double step16 = 1.0 / 65535.0;

std::vector<float> channelOf(const std::filesystem::path& path, const char* name)
{
    Imf::InputFile file(path.c_str());
    const auto window = file.header().dataWindow();
    std::vector<float> numbers(static_cast<std::size_t>((window.max.x + 1) * (window.max.y + 1)));
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice::Make(Imf::FLOAT, numbers.data(), window));
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return numbers;
}

// The channel's number at column x of row y from the top against the bottom-up picture's red.
void expectAlike(const std::vector<float>& topDown, const Picture& picture, std::size_t channel, float scale,
                 float offset)
{
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    ASSERT_EQ(topDown.size(), width * height);
    for (std::size_t y = 0; y < height; ++y)
        for (std::size_t x = 0; x < width; ++x)
            EXPECT_NEAR(topDown[y * width + x],
                        scale * picture.floats[4 * ((height - 1 - y) * width + x) + channel] + offset, 1e-5F);
}

} // namespace

TEST_F(OutputOptions, Exposure_Curve_Gamma_FollowEachOther)
{
    const auto expectTexel = [&](const std::string& options, std::array<double, 3> expected) {
        const auto texel = encoded(options);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(texel[c], expected[c], step16) << options << " channel " << c;
    };
    expectTexel("", {srgbFromLinear(0.18), 1.0, 1.0});
    expectTexel("--gamma srgb --curve none --exposure 0", {srgbFromLinear(0.18), 1.0, 1.0});
    expectTexel("--exposure -2", {srgbFromLinear(0.045), srgbFromLinear(0.25), 1.0});
    expectTexel("--curve reinhard --gamma 1", {0.18 / 1.18, 0.5, 0.8});
    // 2.54 / 3.16, and 4 (10.04 + 0.03) / (4 (9.72 + 0.59) + 0.14)
    expectTexel("--curve filmic --gamma 1", {0.2668989, 0.8037975, 40.28 / 41.38});
    expectTexel("--exposure 1 --curve reinhard --gamma 2",
                {std::sqrt(0.36 / 1.36), std::sqrt(2.0 / 3.0), std::sqrt(8.0 / 9.0)});
}

TEST_F(OutputOptions, Output_IsASectionOfTheScene_ThatOptionsOverride)
{
    here("printf '[output]\\nexposure = 1\\ncurve = \"reinhard\"\\ngamma = 1\\n' >>sky.toml");
    EXPECT_NEAR(encoded("")[1], 2.0 / 3.0, step16);
    EXPECT_NEAR(encoded("--exposure 0")[1], 0.5, step16);
    EXPECT_NEAR(encoded("--gamma srgb")[1], srgbFromLinear(2.0 / 3.0), step16);
    EXPECT_EQ(encoded("--curve none")[1], 1.0);
    EXPECT_NEAR(encoded("--set output.curve=filmic --exposure 0")[1], 0.8037975, step16);
    // What is linear has neither.
    ASSERT_EQ(here("dioptre render sky.toml --size 4x2 --spp 1 -o a.exr").code, 0);
    EXPECT_EQ(readPicture(folder / "a.exr").floats[1], 1.0F);
}

TEST_F(OutputOptions, Depth16_HoldsMoreThan8BitsDo)
{
    ASSERT_EQ(
        here("dioptre render spheres --size 64x36 --spp 4 -o a.exr && dioptre render spheres --size "
             "64x36 --spp 4 --depth 16 -o a.png && dioptre render spheres --size 64x36 --spp 4 --depth 8 "
             "-o b.png && dioptre render spheres --size 64x36 --spp 4 -o c.png && cmp b.png c.png")
            .code,
        0);
    const auto exr = readPicture(folder / "a.exr"), deep = readPicture(folder / "a.png");
    ASSERT_EQ(deep.format, PixelFormat::float32);
    std::set<float> values;
    for (std::size_t i = 0; i < exr.floats.size(); ++i) {
        values.insert(deep.floats[i]);
        // A step is 1/65535 of the encoded value, and linear values change no faster than 2.275 times it.
        EXPECT_NEAR(deep.floats[i], std::min(exr.floats[i], 1.0F), 0.5 * 2.275 * step16 + 1e-7);
    }
    EXPECT_GT(values.size(), 256U);
    EXPECT_EQ(readPicture(folder / "b.png").format, PixelFormat::srgb8);
}

TEST_F(OutputOptions, Hdr_HoldsTheRadianceOfTheExr_ToHalfAStep)
{
    ASSERT_EQ(here("dioptre render still_life --size 64x36 --spp 2 -o a.exr && dioptre render still_life "
                   "--size 64x36 --spp 2 -o a.hdr")
                  .code,
              0);
    const auto exr = readPicture(folder / "a.exr"), hdr = readPicture(folder / "a.hdr");
    ASSERT_EQ(hdr.width, 64);
    ASSERT_EQ(hdr.height, 36);
    for (std::size_t i = 0; i < exr.floats.size(); i += 4) {
        const float largest = std::max({exr.floats[i], exr.floats[i + 1], exr.floats[i + 2]});
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(hdr.floats[i + c], exr.floats[i + c], largest / 256.0F);
    }
    EXPECT_GT(*std::ranges::max_element(hdr.floats), 1.0F);
}

TEST_F(OutputOptions, Settings_StandInEveryFormat)
{
    const std::string scene = "dioptre render spheres --size 16x9 --spp 3 ";
    ASSERT_EQ(here(scene + "-o a.hdr").code, 0);
    const auto hdr = readFile(folder / "a.hdr");
    EXPECT_NE(hdr.find("\ndioptre.spp=3\n"), std::string::npos);
    EXPECT_NE(hdr.find("\ndioptre.input=spheres\n"), std::string::npos);
    ASSERT_EQ(here(scene + "--layers depth -o a.exr").code, 0);
    const Imf::InputFile exr((folder / "a.exr").c_str());
    EXPECT_EQ(exr.header().typedAttribute<Imf::StringAttribute>("dioptre.spp").value(), "3");
    EXPECT_EQ(exr.header().typedAttribute<Imf::StringAttribute>("dioptre.layers").value(), "depth");
    ASSERT_EQ(here(scene + "--exposure 0.5 --curve filmic --gamma 2.2 --depth 16 -o a.png").code, 0);
    const auto png = readFile(folder / "a.png");
    for (const std::string& text : {std::string("dioptre.exposure\0"
                                                "0.5",
                                                20),
                                    std::string("dioptre.curve\0filmic", 20),
                                    std::string("dioptre.gamma\0"
                                                "2.2",
                                                17)})
        EXPECT_NE(png.find(text), std::string::npos) << text;
    ASSERT_EQ(here(scene + "-o b.png").code, 0);
    EXPECT_EQ(readFile(folder / "b.png").find("dioptre.curve"), std::string::npos);
}

TEST_F(OutputOptions, Layers_AreTheViewsNumbers_BesideTheSameColours)
{
    const std::string scene = "dioptre render still_life --size 48x27 --spp 1 ";
    ASSERT_EQ(here(scene + "--layers normal,object,depth -o a.exr && " + scene + "-o b.exr").code, 0);
    for (const char* view : {"depth", "normal", "object"})
        ASSERT_EQ(here(scene + "--view " + view + " -o " + view + ".exr").code, 0);
    EXPECT_EQ(readPicture(folder / "a.exr").floats, readPicture(folder / "b.exr").floats);
    std::vector<std::string> channels;
    const Imf::InputFile file((folder / "a.exr").c_str());
    for (auto c = file.header().channels().begin(); c != file.header().channels().end(); ++c)
        channels.emplace_back(c.name());
    EXPECT_EQ(channels, (std::vector<std::string>{"B", "G", "R", "depth.Z", "normal.X", "normal.Y",
                                                  "normal.Z", "object.id"}));
    expectAlike(channelOf(folder / "a.exr", "depth.Z"), readPicture(folder / "depth.exr"), 0, 1.0F, 0.0F);
    const auto id = channelOf(folder / "a.exr", "object.id");
    EXPECT_EQ(id.front(), -1.0F) << "sky";
    EXPECT_EQ(id.back(), 0.0F) << "floor";
    // A miss is 0 in both, and not 2 * 0 - 1.
    auto normal = readPicture(folder / "normal.exr");
    for (std::size_t i = 0; i < normal.floats.size(); i += 4)
        if (normal.floats[i] == 0.0F && normal.floats[i + 1] == 0.0F && normal.floats[i + 2] == 0.0F)
            std::fill_n(normal.floats.begin() + static_cast<std::ptrdiff_t>(i), 3, 0.5F);
    expectAlike(channelOf(folder / "a.exr", "normal.X"), normal, 0, 2.0F, -1.0F);
    expectAlike(channelOf(folder / "a.exr", "normal.Y"), normal, 1, 2.0F, -1.0F);
    expectAlike(channelOf(folder / "a.exr", "normal.Z"), normal, 2, 2.0F, -1.0F);
}

TEST_F(OutputOptions, PlainShaderAndView_MayHave16Bits)
{
    ASSERT_EQ(here("dioptre render plain.frag --size 4x2 --depth 16 -o a.png").code, 0);
    EXPECT_NEAR(readPicture(folder / "a.png", Encoding::linear).floats[0], 0.3, 0.5 * step16 + 1e-7);
    ASSERT_EQ(here("dioptre render spheres --size 16x9 --spp 1 --view normal --depth 16 -o b.png").code, 0);
    EXPECT_EQ(readPicture(folder / "b.png").format, PixelFormat::float32);
}

TEST_F(OutputOptions, WhereTheyMakeNoSense_AreRefused)
{
    const std::string sky = "dioptre render sky.toml --size 4x2 --spp 1 ";
    for (const char* option : {"--exposure 1", "--curve filmic", "--gamma 2.2", "--depth 16"}) {
        const std::string name = std::string(option).substr(0, std::string(option).find(' '));
        expectRefused(sky + option + " -o a.exr", {name, "a.exr", ".png"});
        expectRefused(sky + option + " -o a.hdr", {name, "a.hdr", ".png"});
        if (name == "--depth")
            continue;
        expectRefused(sky + "--view depth " + option + " -o a.png", {name, "--view depth"});
        expectRefused(std::string("dioptre render plain.frag --size 4x2 -o a.png ") + option,
                      {name, "plain.frag"});
    }
    expectRefused(sky + "--half -o a.hdr", {"--half", "a.hdr", ".exr"});
    expectRefused(sky + "--layers depth -o a.png", {"--layers", "a.png", ".exr"});
    expectRefused(sky + "--layers depth -o a.hdr", {"--layers", "a.hdr", ".exr"});
    expectRefused(sky + "--layers depth --view normal -o a.exr", {"--layers", "--view"});
    expectRefused(sky + "--layers depth --reference -o a.exr", {"--layers", "--reference"});
    expectRefused("dioptre render plain.frag --layers depth -o a.exr", {"--layers", "plain.frag"});
}

TEST_F(OutputOptions, ValuesOfNonsense_AreRefused)
{
    const std::string sky = "dioptre render sky.toml --size 4x2 --spp 1 ";
    expectRefused(sky + "--depth 12 -o a.png", {"--depth"});
    expectRefused(sky + "--exposure nan -o a.png", {"--exposure", "-100 to 100"});
    expectRefused(sky + "--exposure 1e9 -o a.png", {"--exposure", "-100 to 100"});
    expectRefused(sky + "--curve aces -o a.png", {"--curve"});
    for (const char* gamma : {"0", "-1", "nan", "2.2x", "rec709", "1e9"})
        expectRefused(sky + "-o a.png --gamma=" + gamma, {gamma, "srgb or a number"});
    expectRefused(sky + "--layers depth,albedo -o a.exr", {"albedo", "depth, normal, object"});
}
