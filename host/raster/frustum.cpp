#include "raster/frustum.h"

#include "raster/extent.h"

#include <algorithm>
#include <array>

namespace dioptre
{

std::vector<bool> seenBy(const PackedScene& scene, int width, int height, bool endless)
{
    const glm::dvec3 eye(scene.camera.eye);
    const glm::dvec3 forward(scene.camera.forward);
    const double wider = 1.0 + 1.0 / std::min(width, height);
    const glm::dvec3 up = wider * glm::dvec3(scene.camera.up);
    const glm::dvec3 right = wider * width / height * glm::dvec3(scene.camera.right);
    // Inward normals of the planes through the eye and the picture's sides, and of the one across its gaze.
    const std::array<glm::dvec3, 5> inward = {
        glm::dot(right, right) * forward + right, glm::dot(right, right) * forward - right,
        glm::dot(up, up) * forward + up, glm::dot(up, up) * forward - up, forward};
    std::vector<bool> seen;
    for (const auto& object : scene.objects)
        seen.push_back((endless && object.kind == packed::KIND_PLANE) ||
                       std::ranges::all_of(inward, [&](const glm::dvec3& normal) {
                           return extentAlong(object, normal).high >= glm::dot(eye, normal);
                       }));
    return seen;
}

SeenSides sidesSeenFrom(const PackedObject& object, const glm::dvec3& eye)
{
    const glm::dvec3 offset = eye - glm::dvec3(object.shape.anchor);
    const glm::dvec3 axis(object.shape.axis);
    const double height = glm::dot(offset, axis);
    bool outside = true;
    switch (object.kind) {
    case packed::KIND_OPEN_CYLINDER:
        return {true, true};
    case packed::KIND_SPHERE:
        outside = glm::length(offset) > object.shape.anchor.w;
        break;
    case packed::KIND_CAPPED_CYLINDER:
        outside = height < 0.0 || height > object.shape.axis.w ||
                  glm::length(offset - height * axis) > object.shape.anchor.w;
        break;
    default:
        outside = height >= 0.0;
    }
    return {outside, !outside};
}

} // namespace dioptre
