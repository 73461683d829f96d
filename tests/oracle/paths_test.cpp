// Closed forms of whole paths against the same paths walked step by step.
#include "oracle/paths.h"

#include "oracle/optics.h"
#include "problems.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dioptre
{

TEST(Oracle_GlassBall, TurnsARayBy2iMinus2r)
{
    EXPECT_EQ(ballDeviation_rad(0.0, 1.5), 0.0);
    // sin i = 4/5, sin r = 3/5.
    EXPECT_DOUBLE_EQ(ballDeviation_rad(0.8, 4.0 / 3.0), 2.0 * (std::asin(0.8) - std::asin(0.6)));
    EXPECT_DOUBLE_EQ(ballDeviation_rad(1.0, 2.0), 2.0 * std::acos(-1.0) / 3.0);
}

TEST(Oracle_GlassBall, WalkedThroughBothSurfaces_TurnsAsMuch)
{
    for (const double offset : {0.1, 0.5, 0.9, 0.999}) {
        const glm::dvec3 start(-3.0, offset, 0.0);
        const glm::dvec3 forwards(1.0, 0.0, 0.0);
        const RayAnswer entry = solve(problemOf(shapeSphere, {0, 0, 0, 1}, start, forwards));
        const auto within = snellDirection(forwards, entry.normal, 1.5);
        ASSERT_TRUE(entry.hit && within);
        RayProblem inside = problemOf(shapeSphere, {0, 0, 0, 1}, entry.point, *within);
        inside.spawn = true;
        const RayAnswer exit = solve(inside);
        const auto behind = snellDirection(*within, exit.normal, 1.0 / 1.5);
        ASSERT_TRUE(exit.hit && behind);
        EXPECT_NEAR(std::acos(behind->x), ballDeviation_rad(offset, 1.5), 1e-13) << offset;
    }
}

TEST(Oracle_GlassSlab, ShiftsARayAside)
{
    // sin i = 4/5, sin r = 3/5: d (sin i - cos i tan r) = d (0.8 - 0.6 * 0.75).
    EXPECT_DOUBLE_EQ(slabOffset_m(2.0, std::asin(0.8), 4.0 / 3.0), 2.0 * 0.35);
    EXPECT_EQ(slabOffset_m(2.0, 0.0, 1.5), 0.0);
    EXPECT_DOUBLE_EQ(slabOffset_m(1e-5, std::asin(0.8), 4.0 / 3.0), 1e-5 * 0.35);
}

TEST(Oracle_FacingMirrors, AreMetInTurn)
{
    const MirrorStop first = facingMirrors(1.0, {0, 0, 0.5}, {1, 2, 2}, 1);
    EXPECT_EQ(first.point, glm::dvec3(0.25, 0.5, 1.0));
    EXPECT_LE(glm::length(first.direction - glm::dvec3(1, 2, -2) / 3.0), 1e-16);
    EXPECT_DOUBLE_EQ(first.length_m, 0.75);
    const MirrorStop second = facingMirrors(1.0, {0, 0, 0.5}, {1, 2, 2}, 2);
    EXPECT_EQ(second.point, glm::dvec3(0.75, 1.5, 0.0));
    EXPECT_GT(second.direction.z, 0.0);
    const MirrorStop down = facingMirrors(1.0, {0, 0, 0.5}, {1, 2, -2}, 1);
    EXPECT_EQ(down.point, glm::dvec3(0.25, 0.5, 0.0));
    EXPECT_GT(down.direction.z, 0.0);
}

TEST(Oracle_FacingMirrors, WalkedBounceByBounce_LeadToTheSamePoint)
{
    glm::dvec3 point(0.1, -0.3, 0.7);
    glm::dvec3 direction(0.011, 0.007, -1.0);
    const glm::dvec3 origin = point;
    const glm::dvec3 start = direction;
    double length = 0.0;
    for (int bounce = 1; bounce <= 1000; ++bounce) {
        const double step = ((direction.z > 0.0 ? 2.0 : 0.0) - point.z) / direction.z;
        point += step * direction;
        length += step * glm::length(direction);
        direction.z = -direction.z;
        const MirrorStop stop = facingMirrors(2.0, origin, start, bounce);
        ASSERT_LE(glm::length(stop.point - point), 1e-13 * bounce) << bounce;
        ASSERT_NEAR(stop.length_m, length, 1e-13 * length) << bounce;
        ASSERT_LE(glm::length(stop.direction - glm::normalize(direction)), 1e-15) << bounce;
    }
}

TEST(Oracle_WhisperingGallery, OfRightAngles_IsASquare)
{
    const double at45 = std::atan2(1.0, 1.0);
    const std::array<glm::dvec2, 4> corners{{{0, 2}, {-2, 0}, {0, -2}, {2, 0}}};
    for (int bounce = 1; bounce <= 4; ++bounce)
        EXPECT_LE(
            glm::length(whisperingGallery(2.0, at45, bounce) - corners[static_cast<std::size_t>(bounce - 1)]),
            1e-15);
}

TEST(Oracle_WhisperingGallery, WalkedBounceByBounce_LeadsToTheSamePoint)
{
    constexpr double glancing = 0.02;
    glm::dvec3 point(1, 0, 0);
    glm::dvec3 direction(-std::sin(glancing), std::cos(glancing), 0);
    for (int bounce = 1; bounce <= 200; ++bounce) {
        RayProblem chord = problemOf(shapeSphere, {0, 0, 0, 1}, point, direction);
        chord.spawn = true;
        const RayAnswer next = solve(chord);
        ASSERT_TRUE(next.hit);
        const glm::dvec2 known = whisperingGallery(1.0, glancing, bounce);
        EXPECT_LE(glm::length(glm::dvec2(next.point) - known), 1e-14 * bounce * bounce) << bounce;
        direction = mirroredDirection(direction, next.normal);
        point = next.point;
    }
}

} // namespace dioptre
