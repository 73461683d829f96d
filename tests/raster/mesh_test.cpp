// Nets of facets: that they cover their shape once, from outside, and come nearer to it the finer they are.
#include "raster/mesh.h"

#include "kernel/packed_scene.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

using namespace dioptre;

namespace
{

constexpr double pi = std::numbers::pi;

struct Kind {
    int kind;
    const char* name;
    double area;   // of the unit shape
    double volume; // within, where it is closed; else 0
};

const std::vector<Kind>& kinds()
{
    static const std::vector<Kind> all = {
        {packed::KIND_SPHERE, "sphere", 4.0 * pi, 4.0 / 3.0 * pi},
        {packed::KIND_OPEN_CYLINDER, "open cylinder", 2.0 * pi, 0.0},
        {packed::KIND_CAPPED_CYLINDER, "capped cylinder", 4.0 * pi, pi},
        {packed::KIND_PLANE, "plane", 4.0, 0.0},
        {packed::KIND_DISK, "disk", pi, 0.0},
        {packed::KIND_RECTANGLE, "rectangle", 1.0, 0.0},
        {packed::KIND_TRIANGLE, "triangle", 0.5, 0.0},
    };
    return all;
}

struct Sums {
    double area = 0.0;
    double volume = 0.0;
    double backwards = 0.0; // area of facets that face against their corners' normals
};

Sums sumsOf(const Mesh& mesh)
{
    Sums sums;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto& a = mesh.vertices.at(mesh.indices[i]);
        const auto& b = mesh.vertices.at(mesh.indices[i + 1]);
        const auto& c = mesh.vertices.at(mesh.indices[i + 2]);
        const glm::dvec3 p(a.place), q(b.place), r(c.place);
        const glm::dvec3 area = 0.5 * glm::cross(q - p, r - p);
        sums.area += glm::length(area);
        sums.volume += glm::dot(p, glm::cross(q, r)) / 6.0;
        if (glm::dot(area, a.normal + b.normal + c.normal) < -1e-15)
            sums.backwards += glm::length(area);
    }
    return sums;
}

} // namespace

TEST(Mesh, CoversItsShape_AndTheFinerItIsTheBetter)
{
    for (const auto& kind : kinds())
        for (const bool apart : {false, true}) {
            double before = 1e9;
            for (const int n : {8, 16, 32, 64}) {
                const Sums sums = sumsOf(meshOf(kind.kind, n, apart));
                const double off = std::abs(sums.area - kind.area) +
                                   std::abs(kind.volume == 0.0 ? 0.0 : sums.volume - kind.volume);
                EXPECT_EQ(sums.backwards, 0.0) << kind.name << " " << n;
                // Second order: a quarter each time; flat shapes with straight edges are exact.
                EXPECT_LT(off, std::max(before / 3.8, 1e-12)) << kind.name << " " << n << ", apart " << apart;
                before = off;
            }
        }
}

TEST(Mesh, HasAsManyFacetsAsWereAskedFor)
{
    for (const int n : {8, 37, 64}) {
        EXPECT_EQ(meshOf(packed::KIND_SPHERE, n, false).triangles(), 2L * n * n);
        EXPECT_EQ(meshOf(packed::KIND_SPHERE, n, true).triangles(), 2L * n * n);
        EXPECT_EQ(meshOf(packed::KIND_CAPPED_CYLINDER, n, false).triangles(), 6L * n * n);
        EXPECT_EQ(meshOf(packed::KIND_TRIANGLE, n, false).triangles(), 1L * n * n);
        EXPECT_EQ(meshOf(packed::KIND_TRIANGLE, n, true).triangles(), 1L * n * n);
    }
}

TEST(Mesh, OfAClosedShape_HasNoGap)
{
    // Every edge is run along once each way, as places; triangles of no area, at the poles, aside.
    using Place = std::tuple<long, long, long>;
    const auto key = [](const glm::dvec4& p) {
        return Place(std::lround(p.x * 1e9), std::lround(p.y * 1e9), std::lround(p.z * 1e9));
    };
    for (const int kind : {packed::KIND_SPHERE, packed::KIND_CAPPED_CYLINDER})
        for (const bool apart : {false, true}) {
            const Mesh mesh = meshOf(kind, 12, apart);
            std::map<std::pair<Place, Place>, int> runs;
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                std::array<Place, 3> corners;
                for (std::size_t k = 0; k < 3; ++k)
                    corners[k] = key(mesh.vertices[mesh.indices[i + k]].place);
                if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0])
                    continue;
                for (std::size_t k = 0; k < 3; ++k)
                    ++runs[{corners[k], corners[(k + 1) % 3]}];
            }
            for (const auto& [edge, count] : runs) {
                EXPECT_EQ(count, 1);
                EXPECT_EQ(runs.count({edge.second, edge.first}), 1U);
            }
        }
}

TEST(Mesh, FacetsThatAreToldApart_KnowTheirMiddleAndTheirOwnNormal)
{
    for (const auto& kind : kinds()) {
        const Mesh mesh = meshOf(kind.kind, 10, true);
        for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
            const auto& a = mesh.vertices.at(mesh.indices[i]);
            const auto& b = mesh.vertices.at(mesh.indices[i + 1]);
            const auto& c = mesh.vertices.at(mesh.indices[i + 2]);
            EXPECT_EQ(a.facetPlace, b.facetPlace);
            EXPECT_EQ(a.facetNormal, c.facetNormal);
            EXPECT_NEAR(glm::length(a.facetNormal), 1.0, 1e-12) << kind.name;
            const glm::dvec3 across =
                glm::cross(glm::dvec3(b.place - a.place), glm::dvec3(c.place - a.place));
            if (glm::length(across) > 1e-12) { // not at a pole
                EXPECT_NEAR(glm::dot(glm::normalize(across), a.facetNormal), 1.0, 1e-9) << kind.name;
            }
            // The middle lies in the facet's plane.
            EXPECT_NEAR(glm::dot(a.facetPlace - glm::dvec3(a.place), a.facetNormal), 0.0, 1e-12) << kind.name;
        }
    }
}

TEST(Mesh, APlaneWithoutEnd_HasItsCornersAtInfinity)
{
    const Mesh mesh = endlessPlane();
    EXPECT_EQ(mesh.triangles(), 4);
    glm::dvec4 sum(0.0);
    for (const auto& vertex : mesh.vertices)
        sum += vertex.place;
    EXPECT_EQ(sum, glm::dvec4(0.0, 0.0, 0.0, 1.0)) << "one place, and directions all around it";
}
