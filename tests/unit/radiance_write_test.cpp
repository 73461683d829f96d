#include "base/file.h"
#include "picture_fixture.h"

#include <stb_image.h>

#include <cmath>
#include <limits>
#include <memory>

namespace dioptre
{
namespace
{

// What RGBE holds exactly: 8 bits under the exponent of the largest. `width` texels, so that rows under 8
// are flat and longer ones packed.
Picture exactPicture(int width)
{
    Picture picture = floatPicture(width, 2, {});
    for (int i = 0; i < 2 * width; ++i)
        for (const float value : {1.0F + static_cast<float>(i) / 128.0F, 0.25F, 0.0F, 1.0F})
            picture.floats.push_back(value);
    return picture;
}

TEST_F(PictureFile, WriteRadiance_WhatFits_ComesBackUnchanged)
{
    for (const int width : {3, 40}) {
        const Picture source = exactPicture(width);
        writeRadiance(folder_ / "a.hdr", source, {});
        const Picture picture = readPicture(folder_ / "a.hdr");
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.floats, source.floats);
    }
}

// The other reader: stb's, top row first.
TEST_F(PictureFile, WriteRadiance_IsReadAlikeByStb)
{
    const Picture source = exactPicture(40);
    writeRadiance(folder_ / "a.hdr", source, {{"dioptre.spp", "16"}});
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<float, void (*)(void*)> numbers(
        stbi_loadf((folder_ / "a.hdr").c_str(), &width, &height, &channels, 4), &stbi_image_free);
    ASSERT_NE(numbers, nullptr);
    ASSERT_EQ(width, 40);
    ASSERT_EQ(height, 2);
    EXPECT_EQ(std::vector<float>(numbers.get(), numbers.get() + 160),
              std::vector<float>(source.floats.begin() + 160, source.floats.end()));
}

// Half a step is 1/512 of the power of two above the largest channel: here 1, but for the last texel's 2.
TEST_F(PictureFile, WriteRadiance_RoundsToNearest)
{
    writeRadiance(
        folder_ / "a.hdr",
        floatPicture(3, 1, {0.7F, 0.3F, 0.1F, 1.0F, 0.999F, 0.5F, 0.0021F, 1.0F, 1.0F, 0.499F, 0.006F, 1.0F}),
        {});
    const Picture picture = readPicture(folder_ / "a.hdr");
    EXPECT_EQ(picture.floats[0], 179.0F / 256.0F); // 179.2
    EXPECT_EQ(picture.floats[1], 77.0F / 256.0F);  // 76.8
    EXPECT_EQ(picture.floats[2], 26.0F / 256.0F);  // 25.6
    EXPECT_EQ(picture.floats[4], 1.0F);            // 255.7 of 256: a step of 1/128 from there
    EXPECT_EQ(picture.floats[5], 0.5F);
    EXPECT_EQ(picture.floats[6], 0.0F);           // 0.27 of such a step
    EXPECT_EQ(picture.floats[9], 64.0F / 128.0F); // 63.9
    EXPECT_EQ(picture.floats[10], 1.0F / 128.0F); // 0.77
}

TEST_F(PictureFile, WriteRadiance_WhatItCannotHold_BecomesTheNearestThatItCan)
{
    const float infinite = std::numeric_limits<float>::infinity();
    writeRadiance(folder_ / "a.hdr",
                  floatPicture(2, 1, {-1.0F, std::nanf(""), 0.5F, 1.0F, infinite, -infinite, 3e38F, 1.0F}),
                  {});
    const Picture picture = readPicture(folder_ / "a.hdr");
    const float largest = std::ldexp(255.0F, 119);
    EXPECT_EQ(picture.floats, (std::vector<float>{0.0F, 0.0F, 0.5F, 1.0F, largest, 0.0F, largest, 1.0F}));
}

TEST_F(PictureFile, WriteRadiance_SettingsStandInTheHeader_OneALine)
{
    writeRadiance(folder_ / "a.hdr", exactPicture(3), {{"dioptre.legend", "a\n\nb"}, {"dioptre.spp", "16"}});
    const std::string bytes = readFile(folder_ / "a.hdr");
    EXPECT_TRUE(bytes.starts_with("#?RADIANCE\ndioptre.legend=a  b\ndioptre.spp=16\n"))
        << bytes.substr(0, 80);
    EXPECT_EQ(readPicture(folder_ / "a.hdr").floats, exactPicture(3).floats);
}

TEST_F(PictureFile, WriteRadiance_WithoutItsFolder_IsCannotWrite)
{
    try {
        writeRadiance(folder_ / "absent" / "a.hdr", exactPicture(3), {});
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannotWrite);
    }
}

} // namespace
} // namespace dioptre
