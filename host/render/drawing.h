// What can be drawn again and again on the current context: a scene, or a plain shader.
#pragma once

#include "base/picture.h"

#include <functional>

namespace dioptre
{

// What the making of a drawing took; milliseconds.
struct BuildTimes {
    double load = 0.0;      // assembly and upload
    double compile = 0.0;   // compile and link
    double firstDraw = 0.0; // one pixel: drivers compile here
};

class Drawing
{
public:
    Drawing() = default;
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;
    virtual ~Drawing() = default;

    // Draws all pixels anew without waiting for the end, unless `progress`, which is told the share that is
    // drawn, 0..1, wants to hear of it; it may be empty.
    virtual void submit(const std::function<void(double)>& progress = {}) = 0;

    // The same, and returns when they are done.
    void draw(const std::function<void(double)>& progress = {});

    // float32; rows from the bottom up.
    virtual Picture read() const = 0;

    const BuildTimes& times() const
    {
        return times_;
    }

protected:
    BuildTimes times_;
};

} // namespace dioptre
