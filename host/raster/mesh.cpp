#include "raster/mesh.h"

#include "kernel/packed_scene.h"

#include <cmath>
#include <functional>
#include <numbers>

namespace dioptre
{
namespace
{

struct Corner {
    glm::dvec3 place;
    glm::dvec3 normal;
};

// A corner of the net from its shares 0..1 of both sides; the outer side is that of (along the first) x
// (along the second).
using Net = std::function<Corner(double, double)>;

// Longitude runs from z towards x, as latLong() measures it.
Corner onSphere(double around, double up)
{
    const double longitude = 2.0 * std::numbers::pi * around;
    const double latitude = std::numbers::pi * (up - 0.5);
    // Exactly 0 at the poles, so that their corners are one.
    const double ring = up == 0.0 || up == 1.0 ? 0.0 : std::cos(latitude);
    const glm::dvec3 place(ring * std::sin(longitude), std::sin(latitude), ring * std::cos(longitude));
    return {place, place};
}

Corner onWall(double around, double up)
{
    const double longitude = 2.0 * std::numbers::pi * around;
    const glm::dvec3 outward(std::sin(longitude), 0.0, std::cos(longitude));
    return {outward + glm::dvec3(0.0, up, 0.0), outward};
}

Corner onTop(double outward, double around)
{
    const double longitude = 2.0 * std::numbers::pi * around;
    return {{outward * std::sin(longitude), 1.0, outward * std::cos(longitude)}, {0.0, 1.0, 0.0}};
}

Corner onBase(double around, double outward)
{
    const double longitude = 2.0 * std::numbers::pi * around;
    return {{outward * std::sin(longitude), 0.0, outward * std::cos(longitude)}, {0.0, -1.0, 0.0}};
}

Corner onDisk(double outward, double around)
{
    const double angle = 2.0 * std::numbers::pi * around;
    return {{outward * std::cos(angle), outward * std::sin(angle), 0.0}, {0.0, 0.0, 1.0}};
}

Corner onEdges(double u, double v)
{
    return {{u, v, 0.0}, {0.0, 0.0, 1.0}};
}

Corner onPatch(double u, double v)
{
    return {{2.0 * u - 1.0, 2.0 * v - 1.0, 0.0}, {0.0, 0.0, 1.0}};
}

MeshVertex vertexAt(const Corner& corner)
{
    return {glm::dvec4(corner.place, 1.0), corner.normal, {}, {}};
}

// Adds a facet with corners of its own, three or four, counter-clockwise.
void addFacet(Mesh& mesh, const std::vector<Corner>& corners)
{
    glm::dvec3 middle(0.0);
    glm::dvec3 area(0.0); // Newell: right where two corners fall together
    for (std::size_t i = 0; i < corners.size(); ++i) {
        middle += corners[i].place / static_cast<double>(corners.size());
        area += glm::cross(corners[i].place, corners[(i + 1) % corners.size()].place);
    }
    const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
    for (const auto& corner : corners) {
        mesh.vertices.push_back(vertexAt(corner));
        mesh.vertices.back().facetPlace = middle;
        mesh.vertices.back().facetNormal = glm::normalize(area);
    }
    for (std::uint32_t i = 2; i < corners.size(); ++i)
        mesh.indices.insert(mesh.indices.end(), {first, first + i - 1, first + i});
}

// Adds a net of n x n facets, or, where it is half a one, those below its diagonal.
void addNet(Mesh& mesh, const Net& net, int n, bool apart, bool half = false)
{
    const auto at = [&](int i, int j) { return net(static_cast<double>(i) / n, static_cast<double>(j) / n); };
    const auto last = [&](int j) { return half ? n - j : n; }; // of a row
    if (apart) {
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < last(j); ++i) {
                if (!half) {
                    addFacet(mesh, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
                    continue;
                }
                addFacet(mesh, {at(i, j), at(i + 1, j), at(i, j + 1)});
                if (i + 1 < last(j))
                    addFacet(mesh, {at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
            }
        return;
    }
    std::vector<std::uint32_t> firstOfRow;
    for (int j = 0; j <= n; ++j) {
        firstOfRow.push_back(static_cast<std::uint32_t>(mesh.vertices.size()));
        for (int i = 0; i <= last(j); ++i)
            mesh.vertices.push_back(vertexAt(at(i, j)));
    }
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < last(j); ++i) {
            const auto row = firstOfRow[static_cast<std::size_t>(j)] + static_cast<std::uint32_t>(i);
            const auto next = firstOfRow[static_cast<std::size_t>(j) + 1] + static_cast<std::uint32_t>(i);
            mesh.indices.insert(mesh.indices.end(), {row, row + 1, next});
            if (!half || i + 1 < last(j))
                mesh.indices.insert(mesh.indices.end(), {row + 1, next + 1, next});
        }
}

} // namespace

Mesh meshOf(int kind, int facets, bool apart)
{
    Mesh mesh;
    const auto add = [&](const Net& net) { addNet(mesh, net, facets, apart); };
    switch (kind) {
    case packed::KIND_SPHERE:
        add(onSphere);
        break;
    case packed::KIND_CAPPED_CYLINDER:
        add(onTop);
        add(onBase);
        [[fallthrough]];
    case packed::KIND_OPEN_CYLINDER:
        add(onWall);
        break;
    case packed::KIND_PLANE:
        add(onPatch);
        break;
    case packed::KIND_DISK:
        add(onDisk);
        break;
    case packed::KIND_RECTANGLE:
        add(onEdges);
        break;
    default:
        addNet(mesh, onEdges, facets, apart, true);
    }
    return mesh;
}

Mesh endlessPlane()
{
    Mesh mesh;
    const glm::dvec3 normal(0.0, 0.0, 1.0);
    mesh.vertices.push_back({{0.0, 0.0, 0.0, 1.0}, normal, {}, {}});
    for (const auto& [x, y] : {std::pair(1.0, 0.0), {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}})
        mesh.vertices.push_back({{x, y, 0.0, 0.0}, normal, {}, {}});
    for (std::uint32_t i = 0; i < 4; ++i)
        mesh.indices.insert(mesh.indices.end(), {0, 1 + i, 1 + (i + 1) % 4});
    return mesh;
}

} // namespace dioptre
