#include "base/picture.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

using Sizes = std::vector<std::pair<int, int>>;

Sizes sizesOf(const std::vector<Picture>& levels)
{
    Sizes sizes;
    for (const Picture& level : levels)
        sizes.emplace_back(level.width, level.height);
    return sizes;
}

Picture greyFloats(int width, int height, const std::vector<float>& values)
{
    Picture picture{width, height, PixelFormat::float32, {}, {}};
    for (const float value : values)
        picture.floats.insert(picture.floats.end(), {value, 2.0f * value, 3.0f * value, 1.0f});
    return picture;
}

TEST(Mipmaps, Sizes_AreHalvedAndRoundedDownToOne)
{
    EXPECT_EQ(sizesOf(mipmaps(greyFloats(5, 2, std::vector<float>(10)))), (Sizes{{5, 2}, {2, 1}, {1, 1}}));
    EXPECT_EQ(sizesOf(mipmaps(greyFloats(1, 1, {1}))), (Sizes{{1, 1}}));
    EXPECT_EQ(sizesOf(mipmaps(greyFloats(1, 6, std::vector<float>(6)))), (Sizes{{1, 6}, {1, 3}, {1, 1}}));
}

TEST(Mipmaps, Floats_AreTheMeansOfTheirBlocks)
{
    const auto levels = mipmaps(greyFloats(4, 2, {1, 2, 10, 20, 3, 6, 30, 60}));
    EXPECT_EQ(levels[1].floats, (std::vector<float>{3, 6, 9, 1, 30, 60, 90, 1}));
    EXPECT_EQ(levels[2].floats, (std::vector<float>{16.5, 33, 49.5, 1}));
}

TEST(Mipmaps, LevelZero_IsThePictureItself)
{
    const Picture picture{2, 1, PixelFormat::srgb8, {1, 2, 3, 4, 5, 6, 7, 8}, {}};
    EXPECT_EQ(mipmaps(picture)[0].bytes, picture.bytes);
    EXPECT_EQ(mipmaps(picture)[0].format, PixelFormat::srgb8);
}

// Half black and half white is 0.5 of the light, which sRGB encodes as 188; alpha and linear bytes average to
// 128.
TEST(Mipmaps, SrgbColours_AreAveragedInLinearLight)
{
    const std::vector<std::uint8_t> blackAndWhite{0, 0, 0, 0, 255, 255, 255, 255};
    const auto encoded = mipmaps({2, 1, PixelFormat::srgb8, blackAndWhite, {}});
    EXPECT_EQ(encoded[1].bytes, (std::vector<std::uint8_t>{188, 188, 188, 128}));
    const auto linear = mipmaps({2, 1, PixelFormat::linear8, blackAndWhite, {}});
    EXPECT_EQ(linear[1].bytes, (std::vector<std::uint8_t>{128, 128, 128, 128}));
}

// Codes 100 and 200 stand for 0.12744 and 0.57758 of the light; their mean 0.35251 is code 160.
TEST(Mipmaps, SrgbGreys_AreDecodedFirst)
{
    const auto levels = mipmaps({2, 1, PixelFormat::srgb8, {100, 100, 100, 255, 200, 200, 200, 255}, {}});
    EXPECT_EQ(levels[1].bytes, (std::vector<std::uint8_t>{160, 160, 160, 255}));
}

// Blocks that sum to 6, 6, 5, 5 have the means 1.5, 1.5, 1.25, 1.25, stored as 2, 2, 1, 1. The mean of all is
// 22 / 16 = 1.375, stored as 1; taken from the stored ones it would be 6 / 4 = 1.5, stored as 2.
TEST(Mipmaps, Bytes_AreNotRoundedBetweenLevels)
{
    std::vector<std::uint8_t> bytes(4 * 16, 0);
    bytes[4 * 0] = bytes[4 * 2] = 6;
    bytes[4 * 8] = bytes[4 * 10] = 5;
    const auto levels = mipmaps({4, 4, PixelFormat::linear8, bytes, {}});
    EXPECT_EQ(levels[1].bytes[0], 2);
    EXPECT_EQ(levels[1].bytes[8], 1);
    EXPECT_EQ(levels[2].bytes[0], 1);
}

} // namespace
} // namespace dioptre
