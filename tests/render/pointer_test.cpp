// The pointer as Shadertoy tells it, and what else a frame tells a plain shader.
#include "render/plain_uniforms.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

using Four = std::array<double, 4>;

HostNumbers numbersOf(const PlainFrame& frame)
{
    return hostUniforms(frame, 8, 4, {});
}

} // namespace

TEST(Pointer, NeverTouched_IsAllZero)
{
    Pointer pointer;
    pointer.move(3.0, 4.0);
    EXPECT_EQ(pointer.iMouse(), (Four{0, 0, 0, 0}));
    EXPECT_EQ(pointer.at_px, glm::dvec2(3.0, 4.0));
}

TEST(Pointer, Pressed_IsPositiveInTheFirstFrame_AndInZAloneFromThenOn)
{
    Pointer pointer;
    pointer.press(10.7, 20.2);
    EXPECT_EQ(pointer.iMouse(), (Four{10, 20, 10, 20}));
    pointer.nextFrame();
    EXPECT_EQ(pointer.iMouse(), (Four{10, 20, 10, -20}));
}

TEST(Pointer, Dragged_MovesXyAlone)
{
    Pointer pointer;
    pointer.press(10, 20);
    pointer.nextFrame();
    pointer.move(15.9, 25.9);
    EXPECT_EQ(pointer.iMouse(), (Four{15, 25, 10, -20}));
}

TEST(Pointer, Released_HoldsWhereItWas_WithBothSignsNegative)
{
    Pointer pointer;
    pointer.press(10, 20);
    pointer.nextFrame();
    pointer.move(15, 25);
    pointer.release();
    pointer.move(1, 1);
    EXPECT_EQ(pointer.iMouse(), (Four{15, 25, -10, -20}));
    EXPECT_EQ(pointer.at_px, glm::dvec2(1, 1));
    pointer.press(2, 3);
    EXPECT_EQ(pointer.iMouse(), (Four{2, 3, 2, 3}));
}

TEST(Pointer, ClickBetweenTwoFrames_IsStillToldOnce)
{
    Pointer pointer;
    pointer.press(10, 20);
    pointer.release();
    EXPECT_EQ(pointer.iMouse(), (Four{10, 20, -10, 20}));
    pointer.nextFrame();
    EXPECT_EQ(pointer.iMouse(), (Four{10, 20, -10, -20}));
}

TEST(PlainFrame, Date_IsTheOneGiven_OrTheSameDayAlways)
{
    PlainFrame frame;
    frame.time_s = 2.5;
    EXPECT_EQ(numbersOf(frame).at("iDate"), (std::vector<double>{2026, 0, 1, 2.5}));
    frame.date = CalendarDate{2024, 11, 31, 86399.5};
    EXPECT_EQ(numbersOf(frame).at("iDate"), (std::vector<double>{2024, 11, 31, 86399.5}));
    EXPECT_EQ(numbersOf(frame).at("u_date"), (std::vector<double>{2024, 11, 31, 86399.5}));
}

TEST(PlainFrame, LiveValues_AreFedWhereTheyAreSet)
{
    PlainFrame frame;
    for (const char* name :
         {"u_light_type", "u_light_height", "u_camera_position", "u_camera_target", "u_fov_y_deg"})
        EXPECT_FALSE(numbersOf(frame).contains(name)) << name;
    frame.live.lightType = LightType::lightsOnly;
    frame.live.lightHeight_m = 4.5;
    frame.live.camera = Camera{{1, 2, 3}, {4, 5, 6}, 30.0, {}};
    const auto numbers = numbersOf(frame);
    EXPECT_EQ(numbers.at("u_light_type"), std::vector<double>{2});
    EXPECT_EQ(numbers.at("u_light_height"), std::vector<double>{4.5});
    EXPECT_EQ(numbers.at("u_camera_position"), (std::vector<double>{1, 2, 3}));
    EXPECT_EQ(numbers.at("u_camera_target"), (std::vector<double>{4, 5, 6}));
    EXPECT_EQ(numbers.at("u_fov_y_deg"), std::vector<double>{30});
    frame.live.sliders["u_tint"] = {1, 0, 0.5};
    EXPECT_EQ(numbersOf(frame).at("u_tint"), (std::vector<double>{1, 0, 0.5}));
}
