#include "canvas_fixture.h"

#include <limits>

namespace dioptre
{
namespace
{

TEST(Canvas, Blank_IsOpaqueAndOfOneColour)
{
    const Picture canvas = blankCanvas(2, 3, {1, 2, 3});
    EXPECT_EQ(canvas.format, PixelFormat::srgb8);
    ASSERT_EQ(canvas.bytes.size(), 24U);
    EXPECT_EQ(pixelAt(canvas, 1, 2), (Pixel{1, 2, 3, 255}));
}

TEST(Canvas, HalfOfWhiteOverBlack_IsHalfItsLight)
{
    Picture canvas = blankCanvas(1, 1, {0, 0, 0});
    blendPixel(canvas, 0, 0, {255, 255, 255}, 0.5f);
    EXPECT_EQ(pixelAt(canvas, 0, 0), (Pixel{188, 188, 188, 255})); // 1.055 * 0.5^(1/2.4) - 0.055 = 0.7354
}

TEST(Canvas, AllOrNothingOfAColour_ChangesToItOrNothing)
{
    for (int code = 0; code < 256; ++code) {
        const auto byte = static_cast<std::uint8_t>(code);
        Picture canvas = blankCanvas(1, 1, {byte, 7, 9});
        blendPixel(canvas, 0, 0, {200, 100, 50}, 0.0f);
        EXPECT_EQ(pixelAt(canvas, 0, 0), (Pixel{code, 7, 9, 255}));
        blendPixel(canvas, 0, 0, {50, byte, 3}, 1.0f);
        EXPECT_EQ(pixelAt(canvas, 0, 0), (Pixel{50, code, 3, 255}));
    }
}

TEST(Canvas, RectangleOverTheEdges_IsDrawnWithin)
{
    const Pixel ground = {0, 0, 0, 255};
    Picture canvas = blankCanvas(5, 4, {});
    blendRectangle(canvas, {3, -2, 9, 4}, {255, 0, 0});
    const auto ink = inkOf(canvas, ground);
    ASSERT_TRUE(ink);
    EXPECT_EQ(ink->x, 3);
    EXPECT_EQ(ink->y, 0);
    EXPECT_EQ(ink->width, 2);
    EXPECT_EQ(ink->height, 2);
    canvas = blankCanvas(5, 4, {});
    for (const PixelRectangle& outside :
         {PixelRectangle{5, 0, 2, 2}, {-3, 0, 3, 3}, {0, 4, 5, 5}, {1, 1, 0, 2}})
        blendRectangle(canvas, outside, {255, 0, 0});
    EXPECT_FALSE(inkOf(canvas, ground));
}

TEST(Canvas, PictureOverTheEdges_IsCutThere)
{
    const Picture picture = noise(4, 3, 1);
    Picture canvas = blankCanvas(5, 5, {});
    paste(canvas, picture, -1, -2);
    EXPECT_EQ(pixelAt(canvas, 0, 0), pixelAt(picture, 1, 2));
    EXPECT_EQ(pixelAt(canvas, 2, 0), pixelAt(picture, 3, 2));
    EXPECT_EQ(pixelAt(canvas, 3, 0), (Pixel{0, 0, 0, 255}));
    EXPECT_EQ(pixelAt(canvas, 0, 1), (Pixel{0, 0, 0, 255}));
    paste(canvas, picture, 4, 4);
    EXPECT_EQ(pixelAt(canvas, 4, 4), pixelAt(picture, 0, 0));
    const Picture before = canvas;
    paste(canvas, picture, 5, 0);
    paste(canvas, picture, 0, -3);
    EXPECT_EQ(canvas.bytes, before.bytes);
}

TEST(Canvas, LinearPictures_AreEncodedAndOpaque)
{
    Picture canvas = blankCanvas(2, 1, {});
    const float nan = std::numeric_limits<float>::quiet_NaN();
    paste(canvas, {2, 1, PixelFormat::float32, {}, {0.5f, 2.0f, -1.0f, 0.0f, nan, 0.0f, 1.0f, 0.0f}}, 0, 0);
    EXPECT_EQ(pixelAt(canvas, 0, 0), (Pixel{188, 255, 0, 255}));
    EXPECT_EQ(pixelAt(canvas, 1, 0), (Pixel{0, 0, 255, 255}));
    paste(canvas, {1, 1, PixelFormat::linear8, {55, 0, 255, 0}, {}}, 1, 0);
    EXPECT_EQ(pixelAt(canvas, 1, 0), (Pixel{128, 0, 255, 255})); // 1.055 * (55 / 255)^(1/2.4) - 0.055 = 0.502
}

} // namespace
} // namespace dioptre
