// The pointer of a plain shader, as Shadertoy tells it.
#pragma once

#include <glm/glm.hpp>

#include <array>

namespace dioptre
{

// Pixels from the lower left corner; what the button does is told in whole ones. The events between two
// frames are all told to the second.
struct Pointer {
    glm::dvec2 at_px{0.0};   // now, whatever the button: u_mouse
    glm::dvec2 drag_px{0.0}; // where it was last while the button was down
    glm::dvec2 press_px{0.0};
    bool down = false;
    bool pressed = false; // since the frame before

    void press(double x_px, double y_px);
    void move(double x_px, double y_px);
    void release();

    // After a frame has been drawn.
    void nextFrame();

    // xy: drag_px; zw: press_px, z negative while the button is up, w negative but in the frame of the press.
    std::array<double, 4> iMouse() const;
};

} // namespace dioptre
