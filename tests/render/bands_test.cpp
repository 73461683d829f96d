#include "render/bands.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

TEST(RowsAtOnce, PictureThatFits_IsDrawnWhole)
{
    EXPECT_EQ(rowsAtOnce(1280, 720), 720);
    EXPECT_EQ(rowsAtOnce(2048, 2048), 2048);
}

TEST(RowsAtOnce, LargerPicture_IsDrawnInMultiplesOf64RowsWithinTheBound)
{
    EXPECT_EQ(rowsAtOnce(2048, 2049), 2048);
    EXPECT_EQ(rowsAtOnce(20000, 12000), 192); // 64 * 3 * 20000 = 3.84 M of the 4.19 M pixels
    EXPECT_EQ(rowsAtOnce(131072, 131072), 64) << "never fewer";
}

TEST(Bands, RowsOfATile_FollowFromTheTopDownAndBeginAtMultiplesOf64)
{
    const auto bands = bandsOf({0, 128, 300, 450}, 192);
    ASSERT_EQ(bands.size(), 3U);
    EXPECT_EQ(bands[0].y, 128 + 384);
    EXPECT_EQ(bands[0].height, 450 - 384);
    EXPECT_EQ(bands[1].y, 128 + 192);
    EXPECT_EQ(bands[1].height, 192);
    EXPECT_EQ(bands[2].y, 128);
    for (const auto& band : bands)
        EXPECT_EQ(band.width, 300);
}

} // namespace
} // namespace dioptre
