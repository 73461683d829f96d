// Nets of facets over unit shapes, which glsl/raster/unit_shape.glsl places in the scene.
#pragma once

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace dioptre
{

// A corner of facets. Vertices are shared where the shape is smooth; where facets are told apart, each has
// corners of its own.
struct MeshVertex {
    glm::dvec4 place{0.0};       // on the unit shape, homogeneous
    glm::dvec3 normal{0.0};      // of the shape there
    glm::dvec3 facetPlace{0.0};  // the middle of the facet, where facets are told apart
    glm::dvec3 facetNormal{0.0}; // unit on the unit shape
};

// Triangles whose corners run counter-clockwise seen from the outer or front side.
struct Mesh {
    std::vector<MeshVertex> vertices;
    std::vector<std::uint32_t> indices;

    long triangles() const
    {
        return static_cast<long>(indices.size() / 3);
    }
};

// Of a shape of packed::KIND_..., `facets` along both sides of its net: around and from pole to pole of a
// sphere; around and along a cylinder, and around and outward on its caps and on a disk; along the edges of a
// rectangle; of a triangle its sides are cut in so many parts. `apart`: facets are told apart.
Mesh meshOf(int kind, int facets, bool apart);

// A plane without end, from its point to infinity: four triangles.
Mesh endlessPlane();

} // namespace dioptre
