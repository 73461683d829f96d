// What glsl/raster/object.glsl reads of each object.
#pragma once

#include "gl/object.h"
#include "gl/program.h"
#include "kernel/packed_scene.h"

#include <cstddef>
#include <vector>

namespace dioptre
{

// Of one object, as the device holds them. `planeOf` as of ShadowViews.
std::vector<float> numbersOfObject(const PackedScene& scene, const std::vector<int>& planeOf, std::size_t id);

// The numbers of all objects of a scene, of which a program sees one at a time.
struct ObjectBuffer {
    Buffer buffer;
    std::size_t stride = 0; // bytes from an object's numbers to the next one's
};
ObjectBuffer uploadObjects(const PackedScene& scene, const std::vector<int>& planeOf);

// Has the program, which is current, read the object that showObject() names.
void attachObjects(const Program& program);
void showObject(const ObjectBuffer& objects, std::size_t object);

} // namespace dioptre
