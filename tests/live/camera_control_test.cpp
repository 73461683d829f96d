// A camera moved by hand: what stays, what moves which way, and that a scene takes what is copied of it.
#include "live/camera_control.h"

#include "scene/camera.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace dioptre::test
{
namespace
{

constexpr double pi = std::numbers::pi;
constexpr double rounding = 1e-9;

// Five metres before its target, looking along -z.
Camera ahead()
{
    Camera camera;
    camera.eye = {1.0, 2.0, 8.0};
    camera.target = {1.0, 2.0, 3.0};
    camera.fovY_deg = 40.0;
    return camera;
}

Camera oblique()
{
    Camera camera;
    camera.eye = {-3.0, 4.0, 2.5};
    camera.target = {0.5, -1.0, 7.0};
    camera.fovY_deg = 65.0;
    return camera;
}

void expectNear(const glm::dvec3& actual, const glm::dvec3& expected, double tolerance)
{
    for (int axis = 0; axis < 3; ++axis)
        EXPECT_NEAR(actual[axis], expected[axis], tolerance) << "axis " << axis;
}

double distanceOf(const Camera& camera)
{
    return glm::distance(camera.eye, camera.target);
}

bool isFinite(const glm::dmat3& frame)
{
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!std::isfinite(frame[column][row]))
                return false;
    return true;
}

} // namespace

TEST(CameraControl, Orbit_KeepsTargetDistanceAndFieldOfView)
{
    const Camera before = oblique();
    const Camera after = orbited(before, 0.7, -0.4);
    EXPECT_EQ(after.target, before.target);
    EXPECT_EQ(after.fovY_deg, before.fovY_deg);
    EXPECT_NEAR(distanceOf(after), distanceOf(before), rounding);
    EXPECT_GT(glm::distance(after.eye, before.eye), 1.0);
}

// The scene follows the pointer: its right side is seen less, so the eye goes to the left.
TEST(CameraControl, OrbitToTheRightAndUp_EyeGoesLeftAndDown)
{
    const Camera right = orbited(ahead(), 0.1, 0.0);
    expectNear(right.eye - right.target, 5.0 * glm::dvec3(-std::sin(0.1), 0.0, std::cos(0.1)), rounding);
    const Camera up = orbited(ahead(), 0.0, 0.1);
    expectNear(up.eye - up.target, 5.0 * glm::dvec3(0.0, -std::sin(0.1), std::cos(0.1)), rounding);
}

TEST(CameraControl, OrbitOfAFullCircle_IsBackWhereItBegan)
{
    Camera camera = oblique();
    for (int i = 0; i < 12; ++i)
        camera = orbited(camera, pi / 6.0, 0.0);
    expectNear(camera.eye, oblique().eye, 1e-8);
}

TEST(CameraControl, OrbitBeyondThePole_StopsShortOfItWithAFrame)
{
    for (const double up_rad : {-100.0, 100.0}) {
        Camera camera = orbited(ahead(), 0.0, up_rad);
        const glm::dvec3 way = glm::normalize(camera.eye - camera.target);
        EXPECT_LT(std::abs(way.y), 1.0 - 1e-6);
        EXPECT_GT(std::abs(way.y), 0.99);
        EXPECT_GT(way.z, 0.0) << "on the side that it came from";
        EXPECT_TRUE(isFinite(worldFromCamera(camera)));
        camera = orbited(camera, 0.0, -std::copysign(0.5 * pi - 0.01, up_rad)); // and comes back
        EXPECT_NEAR(camera.eye.y, camera.target.y, 1e-8);
    }
}

TEST(CameraControl, OrbitFromStraightAbove_HasAFrame)
{
    Camera camera = ahead();
    camera.eye = camera.target + glm::dvec3(0.0, 3.0, 0.0);
    const Camera moved = orbited(camera, 0.2, 0.2);
    EXPECT_NEAR(distanceOf(moved), 3.0, rounding);
    EXPECT_TRUE(isFinite(worldFromCamera(moved)));
}

TEST(CameraControl, Turn_KeepsEyeAndDistance_AndLooksThatWay)
{
    const Camera right = turned(ahead(), 0.1, 0.0);
    EXPECT_EQ(right.eye, ahead().eye);
    expectNear(right.target - right.eye, 5.0 * glm::dvec3(std::sin(0.1), 0.0, -std::cos(0.1)), rounding);
    const Camera up = turned(ahead(), 0.0, 0.1);
    expectNear(up.target - up.eye, 5.0 * glm::dvec3(0.0, std::sin(0.1), -std::cos(0.1)), rounding);
    EXPECT_NEAR(distanceOf(turned(oblique(), -2.0, 1.0)), distanceOf(oblique()), rounding);
}

TEST(CameraControl, Pan_MovesEyeAndTargetAlikeInThePicturesPlane)
{
    const Camera before = oblique();
    const Camera after = panned(before, 0.3, -0.2);
    const glm::dvec3 move = after.eye - before.eye;
    expectNear(after.target - before.target, move, rounding);
    EXPECT_NEAR(glm::dot(move, before.target - before.eye), 0.0, 1e-8);
    const double height_m = 2.0 * distanceOf(before) * std::tan(0.5 * before.fovY_deg * pi / 180.0);
    EXPECT_NEAR(glm::length(move), height_m * std::hypot(0.3, 0.2), rounding);
}

TEST(CameraControl, PanOfHalfAHeight_TheOldTargetIsAtThePicturesEdge)
{
    const Camera after = panned(ahead(), 0.0, 0.5);
    const glm::dvec3 seen = glm::transpose(worldFromCamera(after)) * (ahead().target - after.eye);
    EXPECT_NEAR(seen.y / seen.z, std::tan(20.0 * pi / 180.0), rounding);
    EXPECT_LT(seen.y, 0.0);
}

TEST(CameraControl, Fly_GoesAlongItsOwnWays)
{
    const Camera after = flown(ahead(), {1.0, 2.0, 3.0});
    expectNear(after.eye - ahead().eye, {1.0, 2.0, -3.0}, rounding);
    expectNear(after.target - ahead().target, {1.0, 2.0, -3.0}, rounding);
    const Camera up = flown(oblique(), {0.0, 1.0, 0.0});
    expectNear(up.eye - oblique().eye, {0.0, 1.0, 0.0}, rounding); // the world's, however the head is held
}

TEST(CameraControl, ZoomInAndOut_IsWhereItBegan_AndEachNotchATenthOfThePicturesHeight)
{
    const auto height = [](const Camera& camera) { return std::tan(0.5 * camera.fovY_deg * pi / 180.0); };
    const Camera closer = zoomed(ahead(), 1.0);
    EXPECT_NEAR(height(ahead()) / height(closer), 1.1, rounding);
    EXPECT_NEAR(zoomed(closer, -1.0).fovY_deg, 40.0, rounding);
    EXPECT_NEAR(zoomed(zoomed(ahead(), 1.0), 1.0).fovY_deg, zoomed(ahead(), 2.0).fovY_deg, rounding);
}

TEST(CameraControl, ZoomWithoutEnd_StaysWithinItsBounds)
{
    EXPECT_EQ(zoomed(ahead(), 1000.0).fovY_deg, 1.0);
    EXPECT_EQ(zoomed(ahead(), -1000.0).fovY_deg, 170.0);
}

// Both ways that a camera leaves the window are read back to a micrometre.
TEST(CameraControl, CopiedCamera_IsReadBackByAScene)
{
    Camera camera = oblique();
    camera.eye = {-1e-9, 123456.7890123, -0.1};
    const Scene ofText = parseScene(tomlOf(camera), "copied.toml");
    const Scene ofValues = parseScene("[camera]\nfov_y_deg = 30\n", "given.toml", overridesOf(camera));
    for (const Scene* scene : {&ofText, &ofValues}) {
        expectNear(scene->camera.eye, camera.eye, 1e-6);
        expectNear(scene->camera.target, camera.target, 1e-6);
        EXPECT_NEAR(scene->camera.fovY_deg, camera.fovY_deg, 1e-6);
    }
}

TEST(CameraControl, CopiedCamera_IsShortAndHoldsFloats)
{
    Camera camera;
    camera.eye = {-0.0000001, 2.0, -1.25};
    camera.target = {0.0, 1e6, 0.333333333};
    camera.fovY_deg = 42.0;
    EXPECT_EQ(tomlOf(camera), "[camera]\neye = [-1e-07, 2.0, -1.25]\ntarget = [0.0, 1000000.0, 0.333333333]\n"
                              "fov_y_deg = 42.0\n");
}

} // namespace dioptre::test
