#include "base/wipe.h"

#include "base/error.h"
#include "canvas_fixture.h"

#include <limits>

namespace dioptre
{
namespace
{

constexpr int wipeWidth = 200, wipeHeight = 80;

Picture leftPicture()
{
    return noise(wipeWidth, wipeHeight, 1);
}

Picture rightPicture()
{
    return noise(wipeWidth, wipeHeight, 2);
}

// Whether the columns from `begin` to `end` - 1 are those of `from`, in the lower half, where there are no
// titles.
bool areOf(const Picture& wipe, const Picture& from, int begin, int end)
{
    const PixelRectangle place{begin, 0, end - begin, wipeHeight / 2};
    return cutOut(wipe, place).bytes == cutOut(from, place).bytes;
}

TEST(Wipe, Columns_AreOfTheirOwnSideOfTheLine)
{
    for (const double share : {0.1, 0.5, 0.77}) {
        const Picture wipe = wiped(leftPicture(), rightPicture(), share, "trace", "phong:64");
        const int divider = static_cast<int>(share * wipeWidth + 0.5);
        EXPECT_EQ(wipe.format, PixelFormat::srgb8);
        EXPECT_TRUE(areOf(wipe, leftPicture(), 0, divider - 1)) << share;
        EXPECT_TRUE(areOf(wipe, rightPicture(), divider + 2, wipeWidth)) << share;
        for (int y = 0; y < wipeHeight; ++y)
            EXPECT_EQ(pixelAt(wipe, divider, y)[0], 240);
    }
}

TEST(Wipe, AtTheEnds_IsOnePictureWithoutALine)
{
    for (const double none : {0.0, -3.0, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_TRUE(
            areOf(wiped(leftPicture(), rightPicture(), none, "a", "b"), rightPicture(), 0, wipeWidth));
    for (const double all : {1.0, 7.0})
        EXPECT_TRUE(areOf(wiped(leftPicture(), rightPicture(), all, "a", "b"), leftPicture(), 0, wipeWidth));
}

// What the titles change of a wipe without them.
PixelRectangle changeBy(double share, const std::string& leftTitle, const std::string& rightTitle)
{
    const Picture plain = wiped(leftPicture(), rightPicture(), share, "", "");
    Picture titled = wiped(leftPicture(), rightPicture(), share, leftTitle, rightTitle);
    for (std::size_t i = 0; i < titled.bytes.size(); ++i)
        titled.bytes[i] = titled.bytes[i] == plain.bytes[i] ? 0 : 255;
    return inkOf(titled, {0, 0, 0, 0}).value_or(PixelRectangle{});
}

TEST(Wipe, Titles_StandInTheirOwnUpperCorner)
{
    const std::string endless(300, 'm');
    const PixelRectangle left = changeBy(0.5, "trace", ""), longLeft = changeBy(0.5, endless, "");
    EXPECT_LT(left.x, 10);
    EXPECT_LT(left.x + left.width, wipeWidth / 2);
    EXPECT_GT(left.y, wipeHeight / 2);
    EXPECT_GT(left.width, 20);
    EXPECT_GT(longLeft.width, left.width);
    EXPECT_LT(longLeft.x + longLeft.width, wipeWidth / 2);
    const PixelRectangle right = changeBy(0.5, "", "trace"), longRight = changeBy(0.5, "", endless);
    EXPECT_GT(right.x, wipeWidth / 2);
    EXPECT_GT(right.x + right.width, wipeWidth - 10);
    EXPECT_GT(longRight.x, wipeWidth / 2 + 1);
    EXPECT_EQ(changeBy(0.01, endless, "").width, 0); // no place for it
    EXPECT_GT(changeBy(0.0, "trace", "phong").x, wipeWidth / 2);
}

TEST(Wipe, LinearPictures_AreEncoded)
{
    Picture half = blankFloats(wipeWidth, wipeHeight);
    half.floats.assign(half.floats.size(), 0.5f);
    const Picture wipe = wiped(half, half, 0.5, "", "");
    EXPECT_EQ(pixelAt(wipe, 3, 3), (Pixel{188, 188, 188, 255}));
    EXPECT_EQ(pixelAt(wipe, wipeWidth - 3, 3), (Pixel{188, 188, 188, 255}));
}

TEST(Wipe, PicturesOfTwoSizes_AreRefused)
{
    try {
        wiped(leftPicture(), noise(wipeWidth, wipeHeight + 1, 3), 0.5, "a", "b");
        ADD_FAILURE() << "nothing was thrown";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        EXPECT_NE(std::string(error.what()).find("200x80 and 200x81"), std::string::npos);
    }
}

} // namespace
} // namespace dioptre
