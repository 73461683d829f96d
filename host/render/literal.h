// Numbers as GLSL literals, and the scene as straight-line code.
#pragma once

#include "kernel/packed_scene.h"
#include "render/plan.h"

#include <string>

namespace dioptre
{

// The shortest literal that reads back as the nearest float: "0.1", "1e-05", "3.0".
std::string literal(double value);

// "vec3(0.0, 1.0, 0.5)", "vec4(...)".
std::string literal(const glm::dvec3& value);
std::string literal(const glm::dvec4& value);

// A row of Shape.
struct ShapeRow {
    const char* name;
    glm::dvec4 packed::Shape::*values;
};

// A row of FineShape.
struct FineRow {
    const char* name;
    glm::dvec4 packed::FineShape::*values;
};

// The part ".xyz" or ".w" of a row of an object's geometry: constants, or the uniforms of one that moves.
std::string rowText(const PackedObject& object, const ShapeRow& row, std::string_view part);
std::string rowText(const PackedObject& object, const FineRow& row, std::string_view part);

// nearestHit() and lightThrough() with every object's geometry as constants, or as uniforms where it moves,
// one call of a kernel per object in the order of their ids.
std::string literalScene(const Scene& scene, const PackedScene& packed, const Plan& plan);

// The same of those that stand apart from the table of glsl/trace/scene_loop.glsl: nearestOfChosen() and
// lightThroughChosen().
std::string literalApart(const Scene& scene, const PackedScene& packed, const Plan& plan);

} // namespace dioptre
