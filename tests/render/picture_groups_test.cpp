// Which pictures share an array texture: every array costs each ray a fetch, but a picture that repeats
// cannot end in the middle of its layer.
#include "render/picture_groups.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

struct Wanted {
    int width, height; // texels
    Repeats repeats;
    PixelFormat format = PixelFormat::srgb8;
};

// The pictures of each group, by index.
std::vector<std::vector<std::size_t>> groupsOf(const std::vector<Wanted>& pictures, bool pad = true)
{
    Plan plan;
    plan.padPictures = pad;
    PackedScene packed;
    for (const auto& [width, height, repeats, format] : pictures) {
        packed.pictures.push_back({Picture{width, height, format, {}, {}}});
        plan.pictureRepeats.push_back(repeats);
    }
    std::vector<std::vector<std::size_t>> groups;
    for (const auto& group : pictureGroups(plan, packed))
        groups.push_back(group.pictures);
    return groups;
}

using Groups = std::vector<std::vector<std::size_t>>;

constexpr Repeats never{false, false}, around{true, false}, everywhere{true, true};

} // namespace

TEST(PictureGroups, SmallerPictures_LieInTheLayersOfTheLargest)
{
    // A ball's picture is as wide as its layer, so that it still wraps around; a wall's wraps nowhere.
    EXPECT_EQ(groupsOf({{1024, 768, never}, {1024, 512, around}, {1024, 1024, everywhere}}),
              Groups({{2, 0, 1}}));
}

TEST(PictureGroups, APictureThatRepeatsWhereItIsSmaller_StaysApart)
{
    EXPECT_EQ(groupsOf({{1024, 1024, everywhere}, {512, 512, around}}), Groups({{0}, {1}}));
    EXPECT_EQ(groupsOf({{1024, 1024, everywhere}, {1024, 512, everywhere}}), Groups({{0}, {1}}));
}

TEST(PictureGroups, OfOneSize_ShareAlways)
{
    EXPECT_EQ(groupsOf({{64, 64, everywhere}, {64, 64, around}}, false), Groups({{0, 1}}));
}

TEST(PictureGroups, OtherFormatsWastefulOrOddSizes_StayApart)
{
    EXPECT_EQ(groupsOf({{1024, 1024, never}, {1024, 1024, never, PixelFormat::float32}}), Groups({{0}, {1}}));
    EXPECT_EQ(groupsOf({{1024, 1024, never}, {256, 512, never}}), Groups({{0}, {1}}));
    // 700 = 4 * 175 halves twice: from afar such a picture would not shrink with its layer.
    EXPECT_EQ(groupsOf({{1024, 1024, never}, {1024, 700, never}}), Groups({{0}, {1}}));
}

TEST(PictureGroups, WithoutPadding_OnlyOneSizeShares)
{
    EXPECT_EQ(groupsOf({{1024, 768, never}, {1024, 1024, everywhere}}, false), Groups({{1}, {0}}));
}
