// Nets of facets on the device.
#pragma once

#include "gl/object.h"
#include "raster/mesh.h"
#include "raster/method.h"

#include <map>

namespace dioptre
{

// What glsl/raster/surface.vert calls its inputs, by location.
struct MeshBuffer {
    VertexArray vertexArray;
    Buffer vertices; // a_place, a_normal and, where facets are told apart, a_facet_place, a_facet_normal
    Buffer indices;
    GLsizei count = 0; // of indices
};

// Its vertices one after the other: place, normal and, where facets are told apart, theirs.
std::vector<float> floatsOf(const Mesh& mesh, bool apart);

// `apart`: with what facets are told apart by.
MeshBuffer uploadMesh(const Mesh& mesh, bool apart);

// The nets of a scene's kinds of shapes, by packed::KIND_...
using MeshBuffers = std::map<int, MeshBuffer>;
MeshBuffers uploadMeshes(const std::vector<int>& kinds, const Method& method);

// Draws all its triangles with the current program and state.
void draw(const MeshBuffer& mesh);

} // namespace dioptre
