#include "oracle/orbit.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

// Spheres and the ray between the first two whose orbit stays longest: along their centres' line, save for a
// hair.
struct Billiard {
    std::vector<MirrorSphere> spheres;
    glm::dvec3 origin, direction;
};

Billiard alongTheFirstTwo(int count, double distance)
{
    Billiard billiard{mirrorSpheres(count, distance), {}, {}};
    const glm::dvec3 a = billiard.spheres[0].centre;
    const glm::dvec3 b = billiard.spheres[1].centre;
    billiard.direction = glm::normalize(b - a);
    billiard.origin = 0.5 * (a + b) + glm::dvec3(0.0, 0.0, 1e-14);
    return billiard;
}

} // namespace

TEST(Oracle_MirrorSpheres, AreAllEquallyFarApart_AboutTheOrigin)
{
    for (int count = 2; count <= 4; ++count) {
        const std::vector<MirrorSphere> spheres = mirrorSpheres(count, 2.5);
        ASSERT_EQ(static_cast<int>(spheres.size()), count);
        glm::dvec3 sum(0.0);
        for (const MirrorSphere& a : spheres) {
            EXPECT_EQ(a.radius, 1.0);
            sum += a.centre;
            for (const MirrorSphere& b : spheres)
                EXPECT_NEAR(glm::length(a.centre - b.centre), &a == &b ? 0.0 : 2.5, 1e-15);
        }
        EXPECT_LE(glm::length(sum), 1e-15);
    }
}

TEST(Oracle_Orbit, BetweenTwoSpheres_MeetsThemInTurn)
{
    const Billiard billiard = alongTheFirstTwo(2, 6.0);
    const std::vector<OrbitStop> orbit =
        mirrorOrbit(billiard.spheres, billiard.origin, billiard.direction, 8);
    ASSERT_EQ(orbit.size(), 8U);
    for (std::size_t i = 0; i < orbit.size(); ++i) {
        EXPECT_EQ(orbit[i].sphere, i % 2 == 0 ? 1 : 0);
        EXPECT_NEAR(orbit[i].point.x, i % 2 == 0 ? 2.0 : -2.0, 1e-10);
    }
}

TEST(Oracle_Orbit, AMissOfAllSpheres_HasNoStops)
{
    const std::vector<MirrorSphere> spheres = mirrorSpheres(3, 6.0);
    EXPECT_TRUE(mirrorOrbit(spheres, {0, 0, 0}, {0, 0, 1}, 10).empty());
    EXPECT_EQ(orbitGrowth_log10(spheres, {0, 0, 0}, {0, 0, 1}, 10), 0.0);
}

TEST(Oracle_Orbit, OfAHairOffTheLineOfCentres_EscapesWhenTheHairHasGrownToARadius)
{
    // From 1e-14 at log10 growth 0.996 a bounce: lost at bounce 14 or 15.
    const Billiard billiard = alongTheFirstTwo(2, 6.0);
    const std::vector<OrbitStop> orbit =
        mirrorOrbit(billiard.spheres, billiard.origin, billiard.direction, 100);
    EXPECT_GE(orbit.size(), 13U);
    EXPECT_LE(orbit.size(), 16U);
}

TEST(Oracle_Orbit, IsWalkedBackwards)
{
    const std::vector<MirrorSphere> spheres = mirrorSpheres(3, 2.5);
    const glm::dvec3 origin = 0.5 * (spheres[0].centre + spheres[1].centre) + glm::dvec3(0.0, 1e-4, 1e-5);
    const std::vector<OrbitStop> orbit = mirrorOrbit(spheres, origin, {1.0, 0.01, 0.0}, 8);
    ASSERT_GE(orbit.size(), 5U);
    const OrbitStop last = orbit[4];
    const OrbitStop before = orbit[3];
    // From the middle of the last leg back to the first stop, and beyond it through the origin.
    const glm::dvec3 middle = 0.5 * (last.point + before.point);
    const std::vector<OrbitStop> back = mirrorOrbit(spheres, middle, before.point - last.point, 4);
    ASSERT_EQ(back.size(), 4U);
    for (std::size_t i = 0; i < back.size(); ++i) {
        EXPECT_EQ(back[i].sphere, orbit[3 - i].sphere);
        EXPECT_LE(glm::length(back[i].point - orbit[3 - i].point), 1e-12);
    }
}

TEST(Oracle_Orbit, TheGrowthOfErrors_IsGaspardAndRices)
{
    EXPECT_NEAR(twoSphereGrowth_log10(6.0, 1.0), 0.996, 5e-4);
    EXPECT_NEAR(twoSphereGrowth_log10(2.5, 1.0), 0.418, 5e-4);
    EXPECT_NEAR(twoSphereGrowth_log10(2.1, 1.0), 0.193, 5e-4);
    struct Scene {
        int count;
        double distance;
        int bounces;
    };
    for (const auto& [count, distance, bounces] :
         {Scene{2, 6.0, 12}, Scene{3, 6.0, 12}, Scene{3, 2.5, 20}, Scene{4, 2.1, 60}}) {
        const Billiard billiard = alongTheFirstTwo(count, distance);
        const double growth =
            orbitGrowth_log10(billiard.spheres, billiard.origin, billiard.direction, bounces);
        const double known = twoSphereGrowth_log10(distance, 1.0);
        EXPECT_NEAR(growth, known, 0.03 * known) << count << " spheres, " << distance << " apart";
    }
}

} // namespace dioptre
