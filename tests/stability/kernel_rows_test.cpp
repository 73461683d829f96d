// What the device gets of a problem, and which variant it meets.
#include "stability/kernel_rows.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre
{
namespace
{

RayProblem planet(double height_m)
{
    RayProblem problem;
    problem.p = {0.0, -1.0e7, 0.0, 1.0e7};
    problem.origin = {0.0, height_m, 0.0};
    problem.direction = {0.6, -0.8, 0.0};
    return problem;
}

// Texels of a row, as glsl/stability/shapes.frag numbers them.
enum Texel : std::size_t { originTexel, directionTexel, directionLowTexel, anchorTexel, anchorLowTexel };

} // namespace

TEST(Variant, HugeRadiusNearby_IsTracedByCurvature)
{
    EXPECT_EQ(strictestFor(planet(1.7), glm::dvec3(0.0)), Variant::curvature);
    EXPECT_EQ(strictestFor(planet(999.0), glm::dvec3(0.0)), Variant::curvature);
    EXPECT_EQ(strictestFor(planet(1001.0), glm::dvec3(0.0)), Variant::compensated);
    EXPECT_EQ(strictestFor(planet(1.7), glm::dvec3(0.0, 2.0e3, 0.0)), Variant::compensated);
    RayProblem plane = planet(1.7);
    plane.primitive = shapePlane;
    EXPECT_EQ(strictestFor(plane, glm::dvec3(0.0)), Variant::compensated);
}

TEST(KernelRows, NumbersThatAreNoFloats_ComeInTwoParts)
{
    RayProblem problem = planet(0.0);
    problem.p[0] = 1.0 / 3.0;
    problem.direction = {0.1, 0.2, -0.9};
    const auto rows = kernelRows(std::span(&problem, 1), Variant::compensated, Frame::given);
    const auto& texels = rows.table.numbers;
    EXPECT_EQ(texels[anchorTexel].x + texels[anchorLowTexel].x, 1.0 / 3.0);
    EXPECT_NE(texels[anchorLowTexel].x, 0.0);
    EXPECT_LT(std::abs(texels[anchorLowTexel].x), 0x1p-25);
    EXPECT_EQ(texels[directionTexel].y + texels[directionLowTexel].y, 0.2);
    EXPECT_NE(texels[directionLowTexel].y, 0.0);
}

TEST(KernelRows, OfTheRaysFrame_BeginAtTheOrigin_AndScaleByPowersOfTwo)
{
    RayProblem problem = planet(3.0);
    problem.tMin = 0.5;
    problem.direction *= 5.0;
    const auto rows = kernelRows(std::span(&problem, 1), Variant::compensated, Frame::ofRay);
    const auto& texels = rows.table.numbers;
    EXPECT_EQ(glm::dvec3(texels[originTexel]), glm::dvec3(0.0));
    const double scale = (texels[anchorTexel].y + texels[anchorLowTexel].y) / -10'000'003.0;
    EXPECT_EQ(scale, std::exp2(std::round(std::log2(scale))));
    // A point t along the row's direction lies where t lengthOfT along the given one does, scaled.
    const double along = texels[directionTexel].x + texels[directionLowTexel].x;
    EXPECT_DOUBLE_EQ(along, rows.lengthOfT.front() * problem.direction.x * scale);
    EXPECT_DOUBLE_EQ(texels[originTexel].w * rows.lengthOfT.front(), 0.5);
}

} // namespace dioptre
