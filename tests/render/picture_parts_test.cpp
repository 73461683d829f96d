// How a picture is cut into parts that show less than the whole scene.
#include "render/picture_parts.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

using namespace dioptre;

namespace
{

Scene sceneOf(const std::string& objects)
{
    return parseScene("[camera]\neye = [0, 0, 5]\ntarget = [0, 0, 0]\nfov_y_deg = 90\n"
                      "[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"
                      "[material.mirror]\nmirror = 1.0\n" +
                          objects,
                      "text.toml");
}

// A ball whose picture is the middle fifth of a square one, as high.
const std::string ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0.9\n";

std::vector<PicturePart> partsOf(const Scene& scene, int width, int height)
{
    return pictureParts(scene, makePlan(scene), width, height);
}

std::string shapeOf(const std::string& shape)
{
    const Scene scene = sceneOf(shape);
    std::string rows;
    const auto tiles = seenInTiles(scene, 160, 160);
    for (std::size_t row = 5; row-- > 0;) {
        for (std::size_t column = 0; column < 5; ++column)
            rows += tiles[row * 5 + column][0] ? '#' : '.';
        rows += '\n';
    }
    return rows;
}

} // namespace

TEST(SeenInTiles, ABallInTheMiddle_IsSeenThereAlone)
{
    EXPECT_EQ(shapeOf(ball), ".....\n.....\n..#..\n.....\n.....\n");
}

TEST(SeenInTiles, ABallThatHoldsTheEye_IsSeenEverywhere)
{
    EXPECT_EQ(shapeOf("[[sphere]]\ncentre = [0, 0, 5]\nradius = 1\n"), "#####\n#####\n#####\n#####\n#####\n");
}

TEST(SeenInTiles, WhatIsBehindTheEye_IsNotSeen)
{
    EXPECT_EQ(shapeOf("[[sphere]]\ncentre = [0, 0, 8]\nradius = 1\n"), ".....\n.....\n.....\n.....\n.....\n");
}

TEST(SeenInTiles, AFloor_EndsAtTheHorizon)
{
    EXPECT_EQ(shapeOf("[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n"),
              ".....\n.....\n#####\n#####\n#####\n");
}

TEST(SeenInTiles, AFloorSeenFromBelow_IsACeiling)
{
    EXPECT_EQ(shapeOf("[[plane]]\npoint = [0, 1, 0]\nnormal = [0, 1, 0]\n"),
              "#####\n#####\n#####\n.....\n.....\n");
}

TEST(SeenInTiles, AnUprightCylinder_IsAColumn)
{
    EXPECT_EQ(shapeOf("[[cylinder]]\nbase = [0, -2.6, 0]\naxis = [0, 5.2, 0]\nradius = 0.5\n"),
              ".....\n..#..\n..#..\n..#..\n.....\n");
}

TEST(SeenInTiles, ATriangleARectangleAndADisk_AreSeenWhereTheyLie)
{
    EXPECT_EQ(shapeOf("[[triangle]]\na = [-4, -4, 0]\nb = [-3.5, -4, 0]\nc = [-4, -3.5, 0]\n"),
              ".....\n.....\n.....\n.....\n#....\n");
    EXPECT_EQ(
        shapeOf("[[rectangle]]\ncorner = [-0.9, -4.9, 0]\nedge_u = [5.8, 0, 0]\nedge_v = [0, 1.8, 0]\n"),
        ".....\n.....\n.....\n.....\n..###\n");
    // On edge, it is a line.
    EXPECT_EQ(shapeOf("[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 2\n"),
              ".....\n.....\n.###.\n.....\n.....\n");
}

TEST(PictureParts, CoverEveryPixelOnce_AtSizesThatTilesDoNotDivide)
{
    for (const auto& [width, height] : {std::pair{333, 217}, {32, 32}, {31, 500}, {640, 1}}) {
        const auto parts = partsOf(sceneOf(ball), width, height);
        std::vector<int> times(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
        for (const auto& part : parts)
            for (const auto& r : part.rectangles)
                for (int y = r.y; y < r.y + r.height; ++y)
                    for (int x = r.x; x < r.x + r.width; ++x)
                        ++times.at(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                                   static_cast<std::size_t>(x));
        EXPECT_EQ(std::ranges::count(times, 1), std::ssize(times)) << width << "x" << height;
    }
}

TEST(PictureParts, OfABallUnderTheSky_AreSkyAndEverything)
{
    const auto parts = partsOf(sceneOf(ball), 160, 160);
    ASSERT_EQ(parts.size(), 2U);
    EXPECT_EQ(parts[0].name, "sky");
    EXPECT_EQ(parts[1].name, "everything");
    ASSERT_EQ(parts[1].rectangles.size(), 1U);
    EXPECT_EQ(parts[1].rectangles[0].x, 64);
    EXPECT_EQ(parts[1].rectangles[0].width, 32);
}

TEST(PictureParts, WhereAMirrorIsSeen_EverythingIs)
{
    const auto parts = partsOf(
        sceneOf("[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n" + ball + "material = \"mirror\"\n"),
        160, 160);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_EQ(parts[1].name, "1 of 2 objects");
    EXPECT_EQ(parts[1].seen, (std::vector<bool>{true, false}));
    EXPECT_EQ(parts[2].seen, (std::vector<bool>{true, true}));
}

TEST(PictureParts, FewerThanAQuarterOfTheTiles_AreNotWorthIt)
{
    // The wall leaves a fifth of the picture to the sky.
    const auto parts =
        partsOf(sceneOf("[[rectangle]]\ncorner = [-9, -2.9, 0]\nedge_u = [18, 0, 0]\nedge_v = [0, 9, 0]\n"),
                160, 160);
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(parts[0].name, "everything");
}

TEST(PictureParts, AreMade_WhereTheirProgramsPay)
{
    const auto cuts = [](const std::string& more, long samples) {
        const Scene scene = sceneOf(ball + more);
        return cutsPicture(scene, makePlan(scene), samples);
    };
    EXPECT_FALSE(cuts("", 160'000));
    EXPECT_TRUE(cuts("", 1280L * 720 * 16));
    EXPECT_TRUE(cuts("[plan]\ntiles = \"on\"\n", 1));
    EXPECT_FALSE(cuts("[plan]\ntiles = \"off\"\n", 1280L * 720 * 16));
    EXPECT_FALSE(cuts("[plan]\ntiles = \"on\"\nforce = \"all\"\n", 1));
    EXPECT_FALSE(cuts("[plan]\ntiles = \"on\"\n[trace]\nform = \"loop\"\n", 1));
    EXPECT_FALSE(cuts("[plan]\ntiles = \"on\"\n[[animate]]\npath = \"camera.eye.0\"\ntimes = [0, 1]\n"
                      "values = [0, 1]\n",
                      1));
}
