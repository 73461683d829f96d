#include "scene/camera.h"

#include "scene/direction.h"

namespace dioptre
{

glm::dmat3 worldFromCamera(const Camera& camera)
{
    const glm::dvec3 back = unit(camera.eye - camera.target);
    const glm::dvec3 y(0.0, 1.0, 0.0);
    const glm::dvec3 roughlyUp = parallel(back, y) ? glm::dvec3(0.0, 0.0, -1.0) : y;
    const glm::dvec3 right = unit(glm::cross(roughlyUp, back));
    return {right, glm::cross(back, right), back};
}

} // namespace dioptre
