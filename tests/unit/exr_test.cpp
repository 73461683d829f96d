#include "base/file.h"
#include "picture_fixture.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfInputFile.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <cmath>
#include <cstring>

namespace dioptre
{
namespace
{

// An EXR by OpenEXR alone, so that writeExr is not its own judge. Every channel of a texel at (x, y) of the
// data window holds x + 10 y + 100 times its place in `channels`.
void writeRamp(const std::filesystem::path& path, const std::vector<std::string>& channels,
               const Imath::Box2i& display, const Imath::Box2i& data, Imf::Compression compression)
{
    Imf::Header header(display, data);
    header.compression() = compression;
    const int width = data.max.x - data.min.x + 1, height = data.max.y - data.min.y + 1;
    const auto texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<std::vector<float>> planes(channels.size(), std::vector<float>(texels));
    Imf::FrameBuffer frame;
    for (std::size_t c = 0; c < channels.size(); ++c) {
        for (std::size_t i = 0; i < texels; ++i) {
            const int x = data.min.x + static_cast<int>(i) % width,
                      y = data.min.y + static_cast<int>(i) / width;
            planes[c][i] = static_cast<float>(x + 10 * y) + 100.0f * static_cast<float>(c);
        }
        header.channels().insert(channels[c], Imf::Channel(Imf::FLOAT));
        frame.insert(channels[c], Imf::Slice::Make(Imf::FLOAT, planes[c].data(), data));
    }
    Imf::OutputFile file(path.c_str(), header);
    file.setFrameBuffer(frame);
    file.writePixels(height);
}

Imath::Box2i box(int left, int top, int right, int bottom)
{
    return {{left, top}, {right, bottom}};
}

std::vector<float> texel(const Picture& picture, int x, int y)
{
    const auto first = picture.floats.begin() + 4 * (y * picture.width + x);
    return {first, first + 4};
}

TEST_F(PictureFile, Exr_FirstRowOfTheFile_IsTheLastOfThePicture)
{
    writeRamp(folder_ / "a.exr", {"R", "G", "B", "A"}, box(0, 0, 2, 3), box(0, 0, 2, 3),
              Imf::ZIP_COMPRESSION);
    const Picture picture = readPicture(folder_ / "a.exr");
    ASSERT_EQ(picture.format, PixelFormat::float32);
    EXPECT_EQ(picture.width, 3);
    EXPECT_EQ(picture.height, 4);
    EXPECT_EQ(texel(picture, 1, 3), (std::vector<float>{1, 101, 201, 301}));
    EXPECT_EQ(texel(picture, 2, 0), (std::vector<float>{32, 132, 232, 332}));
}

TEST_F(PictureFile, Exr_LuminanceAlone_IsGreyAndOpaque)
{
    writeRamp(folder_ / "a.exr", {"Y"}, box(0, 0, 1, 1), box(0, 0, 1, 1), Imf::PIZ_COMPRESSION);
    EXPECT_EQ(texel(readPicture(folder_ / "a.exr"), 1, 0), (std::vector<float>{11, 11, 11, 1}));
}

// The display window is the picture: a smaller data window leaves black around it, a larger one is cropped.
TEST_F(PictureFile, Exr_DataWindow_StandsAtItsPlaceInTheDisplayWindow)
{
    writeRamp(folder_ / "in.exr", {"R", "G", "B"}, box(0, 0, 4, 4), box(1, 2, 2, 3), Imf::NO_COMPRESSION);
    const Picture inside = readPicture(folder_ / "in.exr");
    EXPECT_EQ(inside.width, 5);
    EXPECT_EQ(texel(inside, 1, 4 - 2), (std::vector<float>{21, 121, 221, 1}));
    EXPECT_EQ(texel(inside, 2, 4 - 3), (std::vector<float>{32, 132, 232, 1}));
    EXPECT_EQ(texel(inside, 3, 4 - 3), (std::vector<float>{0, 0, 0, 0}));
    writeRamp(folder_ / "out.exr", {"R", "G", "B"}, box(2, 2, 3, 4), box(-5, -5, 9, 9), Imf::RLE_COMPRESSION);
    const Picture outside = readPicture(folder_ / "out.exr");
    EXPECT_EQ(outside.width, 2);
    EXPECT_EQ(outside.height, 3);
    EXPECT_EQ(texel(outside, 0, 2), (std::vector<float>{22, 122, 222, 1}));
    EXPECT_EQ(texel(outside, 1, 0), (std::vector<float>{43, 143, 243, 1}));
    writeRamp(folder_ / "apart.exr", {"R"}, box(0, 0, 1, 1), box(5, 5, 6, 6), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(readPicture(folder_ / "apart.exr").floats, std::vector<float>(16, 0.0f));
}

// The format of most free skies; lossy, so to 5 %.
TEST_F(PictureFile, Exr_DwaCompression_IsRead)
{
    for (const Imf::Compression compression : {Imf::DWAA_COMPRESSION, Imf::DWAB_COMPRESSION}) {
        writeRamp(folder_ / "a.exr", {"R", "G", "B"}, box(0, 0, 7, 7), box(0, 0, 7, 7), compression);
        EXPECT_NEAR(texel(readPicture(folder_ / "a.exr"), 3, 2)[0], 53.0f, 2.7f);
    }
}

TEST_F(PictureFile, Exr_WithoutColourChannels_IsRefusedAndTheyAreNamed)
{
    writeRamp(folder_ / "a.exr", {"depth.Z", "normal.X"}, box(0, 0, 1, 1), box(0, 0, 1, 1),
              Imf::ZIP_COMPRESSION);
    expectRefused(folder_ / "a.exr", "its channels are depth.Z, normal.X");
}

TEST_F(PictureFile, Exr_CutShort_IsRefused)
{
    writeExr(folder_ / "whole.exr", renderLikePicture(40, 40), ExrDepth::half, {});
    expectEveryCutRefused(folder_ / "cut.exr", readFile(folder_ / "whole.exr"));
}

TEST_F(PictureFile, Exr_OfAbsurdSize_IsRefusedBeforeMemoryIsTaken)
{
    writeExr(folder_ / "a.exr", floatPicture(1, 1, {1, 1, 1, 1}), ExrDepth::full, {});
    for (const char* attribute : {"displayWindow", "dataWindow"}) {
        std::string bytes = readFile(folder_ / "a.exr");
        const std::size_t box2i =
            bytes.find(attribute) + std::strlen(attribute) + 1 + std::strlen("box2i") + 1 + 4;
        bytes.replace(box2i + 8, 4, std::string("\0\0\0\x08", 4)); // xMax = 2^27
        expectRefused(put("b.exr", bytes), "b.exr");
    }
}

TEST_F(PictureFile, WriteExr_FullDepth_IsExact)
{
    Picture source = renderLikePicture(33, 17);
    source.floats[0] = 1e30f;
    source.floats[1] = -1e-30f;
    writeExr(folder_ / "a.exr", source, ExrDepth::full, {});
    EXPECT_EQ(readPicture(folder_ / "a.exr").floats, source.floats);
}

TEST_F(PictureFile, WriteExr_HalfDepth_IsFiniteAndNearestWithinHalf)
{
    const Picture source = floatPicture(1, 2, {0.1f, 1e9f, -1e9f, 1, 65504.0f, std::nanf(""), 0.0f, 1});
    writeExr(folder_ / "a.exr", source, ExrDepth::half, {});
    const Picture picture = readPicture(folder_ / "a.exr");
    EXPECT_NEAR(picture.floats[0], 0.1f, 0.1f / 2048.0f); // 11 bits
    EXPECT_EQ(picture.floats[1], 65504.0f);
    EXPECT_EQ(picture.floats[2], -65504.0f);
    EXPECT_EQ(picture.floats[4], 65504.0f);
    EXPECT_TRUE(std::isnan(picture.floats[5]));
}

TEST_F(PictureFile, WriteExr_SettingsStandInTheHeader)
{
    writeExr(folder_ / "a.exr", floatPicture(1, 1, {0, 0, 0, 1}), ExrDepth::half, {{"samples", "16"}});
    const Imf::InputFile file((folder_ / "a.exr").c_str());
    EXPECT_EQ(file.header().typedAttribute<Imf::StringAttribute>("samples").value(), "16");
    EXPECT_EQ(file.header().compression(), Imf::ZIP_COMPRESSION);
    EXPECT_EQ(file.header().channels().findChannel("A"), nullptr);
}

// By OpenEXR alone: the layer's first row is the file's last, in 32 bits even where the colours have 16.
TEST_F(PictureFile, WriteExr_Layers_AreFloatChannelsBesideTheColours)
{
    const Picture source = floatPicture(2, 2, std::vector<float>(16, 0.5F));
    writeExr(folder_ / "a.exr", source, ExrDepth::half, {},
             {{"depth.Z", {1.0F, 2.0F, 3.0F, 70000.0F}}, {"object.id", {-1.0F, 0.0F, 4097.0F, 7.0F}}});
    Imf::InputFile file((folder_ / "a.exr").c_str());
    EXPECT_EQ(file.header().channels().findChannel("depth.Z")->type, Imf::FLOAT);
    EXPECT_EQ(file.header().channels().findChannel("R")->type, Imf::HALF);
    std::vector<float> depth(4), id(4);
    Imf::FrameBuffer frame;
    frame.insert("depth.Z", Imf::Slice::Make(Imf::FLOAT, depth.data(), file.header().dataWindow()));
    frame.insert("object.id", Imf::Slice::Make(Imf::FLOAT, id.data(), file.header().dataWindow()));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    EXPECT_EQ(depth, (std::vector<float>{3.0F, 70000.0F, 1.0F, 2.0F}));
    EXPECT_EQ(id, (std::vector<float>{4097.0F, 7.0F, -1.0F, 0.0F}));
    EXPECT_EQ(readPicture(folder_ / "a.exr").floats, [&] {
        std::vector<float> floats(16, 0.5F);
        for (std::size_t i = 3; i < 16; i += 4)
            floats[i] = 1.0F;
        return floats;
    }());
}

TEST_F(PictureFile, ReadExr_OfAChannelWithFewerNumbersThanTexels_IsRefused)
{
    Imf::Header header(4, 4);
    header.channels().insert("R", Imf::Channel(Imf::FLOAT, 2, 2));
    std::vector<float> numbers(4, 0.5F);
    Imf::FrameBuffer frame;
    frame.insert("R", Imf::Slice::Make(Imf::FLOAT, numbers.data(), header.dataWindow(), 4, 8, 2, 2));
    {
        Imf::OutputFile file((folder_ / "a.exr").c_str(), header);
        file.setFrameBuffer(frame);
        file.writePixels(4);
    }
    try {
        readPicture(folder_ / "a.exr");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        EXPECT_NE(std::string(error.what()).find("channel R has fewer numbers"), std::string::npos)
            << error.what();
    }
}

TEST_F(PictureFile, WriteExr_SettingWithANameOfTheFormat_IsRefused)
{
    try {
        writeExr(folder_ / "a.exr", floatPicture(1, 1, {0, 0, 0, 1}), ExrDepth::half, {{"channels", "x"}});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannotWrite);
    }
    EXPECT_FALSE(std::filesystem::exists(folder_ / "a.exr"));
}

} // namespace
} // namespace dioptre
