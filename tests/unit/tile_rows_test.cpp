#include "base/tile_rows.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

// From the top down each tile ends where the next begins, at a group's edge, and none is empty.
TEST(TileRows, OfEveryHeightAndNumber_CoverEachRowOnce)
{
    for (const int height : {1, 63, 64, 65, 128, 500, 719, 720, 1081, 12000})
        for (int tiles = 1; tiles <= mostTiles(height); ++tiles) {
            int above = height;
            for (int tile = 1; tile <= tiles; ++tile) {
                const TileRows rows = tileRows(height, tile, tiles);
                ASSERT_EQ(rows.first + rows.count, above) << tile << "/" << tiles << " of " << height;
                ASSERT_GT(rows.count, 0) << tile << "/" << tiles << " of " << height;
                ASSERT_EQ(rows.first % 64, 0) << tile << "/" << tiles << " of " << height;
                above = rows.first;
            }
            ASSERT_EQ(above, 0) << tiles << " of " << height;
        }
}

// 720 rows are 11 groups of 64 and one of 16, which is the topmost.
TEST(TileRows, TheTopTile_HoldsTheGroupThatIsCutOff)
{
    EXPECT_EQ(mostTiles(720), 12);
    EXPECT_EQ(tileRows(720, 1, 12).first, 704);
    EXPECT_EQ(tileRows(720, 1, 12).count, 16);
    EXPECT_EQ(tileRows(720, 1, 2).first, 384);
    EXPECT_EQ(tileRows(720, 1, 2).count, 336);
    EXPECT_EQ(tileRows(720, 2, 2).first, 0);
    EXPECT_EQ(tileRows(720, 2, 2).count, 384);
}

TEST(TileRows, OfLargePictures_DoNotOverflow)
{
    constexpr int height = 1'000'000, tiles = 15'625;
    EXPECT_EQ(mostTiles(height), tiles);
    EXPECT_EQ(tileRows(height, 1, tiles).first, 999'936);
    EXPECT_EQ(tileRows(height, tiles, tiles).count, 64);
}

} // namespace
} // namespace dioptre
