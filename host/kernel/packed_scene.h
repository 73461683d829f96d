// A scene as numbers, ready for the device or for the double-precision reference: what
// glsl/shared/structs.glsl declares, in doubles, in the scene frame (the world less the scene origin).
#pragma once

#include "base/picture.h"

#include <glm/glm.hpp>

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// The shared files, read here with float as double; the device gets the same values rounded.
namespace packed
{
using vec4 = glm::dvec4;
#define float double
#define HAS_DOUBLE
#include "../glsl/shared/constants.glsl"
#undef HAS_DOUBLE
#include "../glsl/shared/structs.glsl"
#undef float

static_assert(sizeof(Shape) == 4 * sizeof(vec4) && sizeof(Light) == 6 * sizeof(vec4));
static_assert(sizeof(Material) == 12 * sizeof(vec4) &&
              offsetof(Material, shadow_absorption) == 10 * sizeof(vec4));
static_assert(sizeof(Camera) == 4 * sizeof(vec4) && sizeof(Sky) == 4 * sizeof(vec4));
} // namespace packed

struct PackedObject {
    int kind = 0;     // packed::KIND_...
    int material = 0; // index into PackedScene::materials
    packed::Shape shape{};
    packed::FineShape fine{};
    bool apart = false; // has a kernel of its own, and no place among its kind
    int moving = -1;    // slot of u_moving in literal geometry, -1 for an object that stands still
};

enum class RayTree { single, chain, heaviestFirst, breadthFirst, depthFirst };

struct PackedScene {
    std::vector<PackedObject> objects; // by object id
    std::vector<packed::Material> materials;
    std::vector<packed::Light> lights; // by kind: directional, points, spots, glowing spheres
    int firstPoint = 0;                // index of the first light of its kind or a later one
    int firstSpot = 0;
    int firstGlow = 0;
    packed::Camera camera{};
    packed::Sky sky{};
    glm::dvec3 ambient{0.0};
    RayTree tree = RayTree::single;
    int budget = 1;      // rays a sample
    int depth = 1 << 20; // most bounces
    int poolSlots = 3;
    double cutOff = 0.0;                        // of a path's weight
    std::vector<std::vector<Picture>> pictures; // mip chains, by picture index
    std::vector<Picture> sky_picture;           // none or one
    std::optional<double> skyPictureBrightness; // what nearly all of it stays below; unset until asked for
};

// The table of glsl/trace/scene_loop.glsl.
struct ShapeTable {
    std::vector<packed::Shape> shapes; // sorted by kind, then by object id; last those that stand apart
    std::vector<packed::vec4> index;
    std::array<packed::vec4, packed::KIND_COUNT + 1> kindFirst{};
};
ShapeTable shapeTable(const PackedScene& scene);

// The same with every object among its kind; where there is none, with one that nothing meets.
ShapeTable plainShapeTable(const PackedScene& scene);

} // namespace dioptre
