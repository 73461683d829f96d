#include "render/drawing.h"

#include <glad/gl.h>

namespace dioptre
{

void Drawing::draw(const std::function<void(double)>& progress)
{
    submit(progress);
    glFinish();
}

} // namespace dioptre
