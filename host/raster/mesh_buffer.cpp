#include "raster/mesh_buffer.h"

#include "base/error.h"
#include "kernel/packed_scene.h"

#include <array>

namespace dioptre
{
namespace
{

void append(std::vector<float>& values, const glm::dvec3& vector)
{
    for (int i = 0; i < 3; ++i)
        values.push_back(static_cast<float>(vector[i]));
}

template <typename Number>
Buffer uploadBuffer(GLenum target, const std::vector<Number>& values)
{
    GLuint name = 0;
    glGenBuffers(1, &name);
    Buffer buffer(name);
    glBindBuffer(target, name);
    while (glGetError() != GL_NO_ERROR) {
    }
    glBufferData(target, static_cast<GLsizeiptr>(values.size() * sizeof(Number)), values.data(),
                 GL_STATIC_DRAW);
    if (glGetError() == GL_OUT_OF_MEMORY)
        fail(ExitCode::retry, "the driver has no memory for so many facets",
             "draw with fewer, as in --method phong:64");
    return buffer;
}

} // namespace

std::vector<float> floatsOf(const Mesh& mesh, bool apart)
{
    std::vector<float> values;
    values.reserve(mesh.vertices.size() * (apart ? 13 : 7));
    for (const auto& vertex : mesh.vertices) {
        append(values, glm::dvec3(vertex.place));
        values.push_back(static_cast<float>(vertex.place.w));
        append(values, vertex.normal);
        if (apart) {
            append(values, vertex.facetPlace);
            append(values, vertex.facetNormal);
        }
    }
    return values;
}

MeshBuffer uploadMesh(const Mesh& mesh, bool apart)
{
    MeshBuffer buffer;
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    buffer.vertexArray = VertexArray(name);
    glBindVertexArray(name);
    buffer.vertices = uploadBuffer(GL_ARRAY_BUFFER, floatsOf(mesh, apart));
    buffer.indices = uploadBuffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices);
    buffer.count = static_cast<GLsizei>(mesh.indices.size());
    const std::array<GLint, 4> sizes = {4, 3, 3, 3};
    const std::size_t stride = (apart ? 13 : 7) * sizeof(float);
    std::size_t offset = 0;
    for (GLuint location = 0; location < (apart ? 4U : 2U); ++location) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, sizes[location], GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                              reinterpret_cast<const void*>(offset)); // NOLINT: OpenGL takes offsets so
        offset += static_cast<std::size_t>(sizes[location]) * sizeof(float);
    }
    glBindVertexArray(0);
    return buffer;
}

MeshBuffers uploadMeshes(const std::vector<int>& kinds, const Method& method)
{
    const bool apart = method.shading == Shading::flat;
    MeshBuffers buffers;
    for (const int kind : kinds)
        if (!buffers.contains(kind)) {
            const bool endless = kind == packed::KIND_PLANE && hasEndlessPlanes(method);
            buffers.emplace(kind,
                            uploadMesh(endless ? endlessPlane() : meshOf(kind, method.facets, apart), apart));
        }
    return buffers;
}

void draw(const MeshBuffer& mesh)
{
    glBindVertexArray(mesh.vertexArray.name());
    glDrawElements(GL_TRIANGLES, mesh.count, GL_UNSIGNED_INT, nullptr);
}

} // namespace dioptre
