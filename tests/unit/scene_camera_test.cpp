// The frame that a camera looks along.
#include "scene/camera.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

TEST(Camera, Frame_IsRightHandedAndLooksAtTheTarget)
{
    Camera camera;
    camera.eye = {0.0, 0.0, 5.0};
    EXPECT_EQ(worldFromCamera(camera), glm::dmat3(1.0));
    camera.eye = {4.0, 3.0, -1.0};
    const glm::dmat3 frame = worldFromCamera(camera);
    EXPECT_NEAR(glm::determinant(frame), 1.0, 1e-15);
    EXPECT_NEAR(glm::dot(frame[2], glm::normalize(camera.eye)), 1.0, 1e-15);
    EXPECT_EQ(frame[0].y, 0.0); // the horizon is level
}

TEST(Camera, LookingStraightDown_HasMinusZUpInThePicture)
{
    Camera camera;
    camera.eye = {0.0, 5.0, 0.0};
    const glm::dmat3 frame = worldFromCamera(camera);
    EXPECT_EQ(frame[0], glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(frame[1], glm::dvec3(0.0, 0.0, -1.0));
    EXPECT_EQ(frame[2], glm::dvec3(0.0, 1.0, 0.0));
}

} // namespace

} // namespace dioptre
