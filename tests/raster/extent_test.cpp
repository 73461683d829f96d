// How far shapes reach, and which the camera cannot see, against many random places of them.
#include "raster/extent.h"
#include "raster/frustum.h"

#include "raster/mesh.h"
#include "render/pack.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace dioptre;

namespace
{

class Chance
{
public:
    explicit Chance(unsigned seed) : generator_(seed) {}
    double between(double low, double high)
    {
        return std::uniform_real_distribution<double>(low, high)(generator_);
    }
    glm::dvec3 vector(double size)
    {
        return {between(-size, size), between(-size, size), between(-size, size)};
    }

private:
    std::mt19937 generator_;
};

std::vector<Primitive> someOfEachKind(Chance& chance)
{
    return {Sphere{chance.vector(5.0), chance.between(0.1, 2.0)},
            Cylinder{chance.vector(5.0), chance.vector(2.0), chance.between(0.1, 2.0), false},
            Cylinder{chance.vector(5.0), chance.vector(2.0), chance.between(0.1, 2.0), true},
            Disk{chance.vector(5.0), chance.vector(1.0), chance.between(0.1, 2.0)},
            Rectangle{chance.vector(5.0), chance.vector(2.0), chance.vector(2.0)},
            Triangle{chance.vector(5.0), chance.vector(5.0), chance.vector(5.0)}};
}

// Places of the shape: the corners of a fine net, by the formulas of glsl/raster/unit_shape.glsl in its own
// words.
std::vector<glm::dvec3> placesOf(const Primitive& primitive, const PackedObject& packed)
{
    std::vector<glm::dvec3> places;
    for (const auto& vertex : meshOf(packed.kind, 64, false).vertices) {
        const glm::dvec3 at(vertex.place);
        const glm::dvec3 u(packed.shape.along_u);
        const glm::dvec3 v(packed.shape.along_v);
        const glm::dvec3 axis(packed.shape.axis);
        if (const auto* sphere = std::get_if<Sphere>(&primitive))
            places.push_back(sphere->centre + sphere->radius * at);
        else if (const auto* cylinder = std::get_if<Cylinder>(&primitive))
            places.push_back(cylinder->base + cylinder->axis * at.y +
                             cylinder->radius * (at.x * u + at.z * v));
        else if (const auto* disk = std::get_if<Disk>(&primitive))
            places.push_back(disk->centre + disk->radius * (at.x * u + at.y * v));
        else if (const auto* rectangle = std::get_if<Rectangle>(&primitive))
            places.push_back(rectangle->corner + at.x * rectangle->edgeU + at.y * rectangle->edgeV);
        else if (const auto* triangle = std::get_if<Triangle>(&primitive))
            places.push_back(triangle->a + at.x * (triangle->b - triangle->a) +
                             at.y * (triangle->c - triangle->a));
    }
    return places;
}

} // namespace

TEST(Extent, IsThatOfAllPlacesOfTheShape)
{
    Chance chance(7);
    for (int round = 0; round < 100; ++round)
        for (const auto& primitive : someOfEachKind(chance)) {
            const PackedObject packed = packShape({"", primitive, 0, 0.0, {}}, glm::dvec3(0.0));
            const glm::dvec3 direction = chance.vector(1.0);
            const Extent extent = extentAlong(packed, direction);
            double low = 1e9;
            double high = -1e9;
            for (const auto& place : placesOf(primitive, packed)) {
                low = std::min(low, glm::dot(place, direction));
                high = std::max(high, glm::dot(place, direction));
            }
            const double width = std::max(extent.high - extent.low, 1e-9);
            EXPECT_GE(low, extent.low - 1e-9 * width) << "round " << round << ", kind " << packed.kind;
            EXPECT_LE(high, extent.high + 1e-9 * width) << "round " << round << ", kind " << packed.kind;
            EXPECT_LT(low - extent.low + extent.high - high, 0.01 * width)
                << "too wide: round " << round << ", kind " << packed.kind;
        }
}

namespace
{

PackedScene sceneOf(const std::vector<PackedObject>& objects, const glm::dvec3& eye, double fov)
{
    PackedScene scene;
    scene.objects = objects;
    scene.camera.eye = glm::dvec4(eye, -1.0);
    const double half = std::tan(0.5 * fov);
    scene.camera.right = {half, 0.0, 0.0, 0.0};
    scene.camera.up = {0.0, half, 0.0, 0.0};
    scene.camera.forward = {0.0, 0.0, -1.0, 0.0};
    return scene;
}

} // namespace

TEST(Frustum, KeepsWhateverAPixelShows_AndCullsMostOfTheRest)
{
    Chance chance(11);
    int shown = 0;
    int kept = 0;
    int hidden = 0;
    for (int round = 0; round < 200; ++round) {
        const auto primitives = someOfEachKind(chance);
        std::vector<PackedObject> objects;
        for (const auto& primitive : primitives)
            objects.push_back(packShape({"", primitive, 0, 0.0, {}}, glm::dvec3(0.0)));
        const PackedScene scene = sceneOf(objects, chance.vector(6.0), chance.between(0.2, 2.0));
        const auto seen = seenBy(scene, 160, 90, false);
        for (std::size_t id = 0; id < objects.size(); ++id) {
            const auto places = placesOf(primitives[id], objects[id]);
            const bool inView = std::ranges::any_of(places, [&](const glm::dvec3& place) {
                const glm::dvec3 offset = place - glm::dvec3(scene.camera.eye);
                const double half = scene.camera.up.y;
                return offset.z < 0.0 && std::abs(offset.y) <= -offset.z * half &&
                       std::abs(offset.x) <= -offset.z * half * 160.0 / 90.0;
            });
            EXPECT_TRUE(seen[id] || !inView) << "round " << round << ", kind " << objects[id].kind;
            shown += inView ? 1 : 0;
            kept += seen[id] && !inView ? 1 : 0;
            hidden += inView ? 0 : 1;
        }
    }
    EXPECT_GT(shown, 100);
    EXPECT_LT(kept, hidden / 5) << "planes alone cannot tell all, but nearly";
}

TEST(Frustum, APlaneWithoutEndIsAlwaysSeen_ItsPatchIsNot)
{
    auto plane = packShape({"", Plane{{0.0, -1.0, 50.0}, {0.0, 1.0, 0.0}, {}}, 0, 0.0, {}}, glm::dvec3(0.0));
    plane.shape.anchor.w = 2.0; // behind the eye
    const PackedScene scene = sceneOf({plane}, glm::dvec3(0.0), 1.0);
    EXPECT_TRUE(seenBy(scene, 16, 9, true)[0]);
    EXPECT_FALSE(seenBy(scene, 16, 9, false)[0]);
}

TEST(Sides, AreThoseThatFaceTheEye)
{
    const auto of = [](const Primitive& primitive, const glm::dvec3& eye) {
        return sidesSeenFrom(packShape({"", primitive, 0, 0.0, {}}, glm::dvec3(0.0)), eye);
    };
    const Sphere sphere{{0.0, 0.0, 0.0}, 1.0};
    EXPECT_TRUE(of(sphere, {0.0, 0.0, 1.1}).outer);
    EXPECT_FALSE(of(sphere, {0.0, 0.0, 1.1}).inner);
    EXPECT_TRUE(of(sphere, {0.0, 0.0, 0.9}).inner);
    Cylinder can{{0.0, 0.0, 0.0}, {0.0, 2.0, 0.0}, 1.0, true};
    EXPECT_FALSE(of(can, {0.0, 2.1, 0.0}).inner);
    EXPECT_TRUE(of(can, {0.5, 1.0, 0.5}).inner);
    can.capped = false;
    EXPECT_TRUE(of(can, {0.0, 5.0, 0.0}).inner) << "through the open end";
    EXPECT_TRUE(of(can, {0.0, 5.0, 0.0}).outer);
    const Disk disk{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, 1.0};
    EXPECT_TRUE(of(disk, {0.3, 0.0, 1.0}).outer);
    EXPECT_FALSE(of(disk, {0.3, 0.0, 1.0}).inner);
    EXPECT_TRUE(of(disk, {0.3, 0.0, -1.0}).inner);
}
