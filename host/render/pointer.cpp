#include "render/pointer.h"

namespace dioptre
{

void Pointer::press(double x_px, double y_px)
{
    at_px = {x_px, y_px};
    drag_px = glm::floor(at_px);
    press_px = drag_px;
    down = true;
    pressed = true;
}

void Pointer::move(double x_px, double y_px)
{
    at_px = {x_px, y_px};
    if (down)
        drag_px = glm::floor(at_px);
}

void Pointer::release()
{
    down = false;
}

void Pointer::nextFrame()
{
    pressed = false;
}

std::array<double, 4> Pointer::iMouse() const
{
    return {drag_px.x, drag_px.y, down ? press_px.x : -press_px.x, pressed ? press_px.y : -press_px.y};
}

} // namespace dioptre
