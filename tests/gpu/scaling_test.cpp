// A scene and the same scene 1,024 times as large or as small are one picture, bit for bit: nothing in the
// tracer has a length of its own.
#include "scene/load.h"
#include "support/compare.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

struct Scaled {
    double s; // power of two, so that every product is exact

    void operator()(Sphere& shape) const
    {
        shape.centre *= s;
        shape.radius *= s;
    }
    void operator()(Cylinder& shape) const
    {
        shape.base *= s;
        shape.axis *= s;
        shape.radius *= s;
    }
    void operator()(Plane& shape) const
    {
        shape.point *= s;
    }
    void operator()(Disk& shape) const
    {
        shape.centre *= s;
        shape.radius *= s;
    }
    void operator()(Rectangle& shape) const
    {
        shape.corner *= s;
        shape.edgeU *= s;
        shape.edgeV *= s;
    }
    void operator()(Triangle& shape) const
    {
        shape.a *= s;
        shape.b *= s;
        shape.c *= s;
    }
};

void scale(Scene& scene, double s)
{
    scene.camera.eye *= s;
    scene.camera.target *= s;
    for (auto& object : scene.objects)
        std::visit(Scaled{s}, object.primitive);
    for (auto& material : scene.materials) {
        material.size *= s;
        material.absorption /= s;
        if (material.checker)
            material.checker->size *= s;
    }
    for (auto& light : scene.lights) {
        light.position *= s;
        light.attenuation.y /= s;
        light.attenuation.z /= s * s;
    }
    for (auto& sight : scene.sights) {
        sight.camera.eye *= s;
        sight.camera.target *= s;
        for (auto& primitive : sight.moving)
            std::visit(Scaled{s}, primitive);
    }
    for (auto& typical : scene.typical)
        scale(typical, s);
}

class Scaling : public testing::TestWithParam<std::filesystem::path>
{
};

INSTANTIATE_TEST_SUITE_P(Scenes, Scaling, testing::ValuesIn(galleryScenes()),
                         [](const auto& info) { return info.param.stem().string(); });

PreparedScene preparedAt(const std::filesystem::path& path, double s, const ViewSettings& view)
{
    Scene scene = loadScene(path, ownPictures(path), 0.0, places());
    scale(scene, s);
    return prepare(scene, view);
}

// The length at which the tracer stops light from growing brighter is the scene's own here, and so is the
// cut-off, which hangs on the brightest light.
Picture drawn(const std::filesystem::path& path, double s)
{
    const ViewSettings view{96, 54, 1, glslFolder()};
    PreparedScene prepared = preparedAt(path, s, view);
    for (auto& light : prepared.packed.lights)
        if (light.specular.w == packed::NEAREST_LIGHT)
            light.specular.w *= s;
    prepared.packed.cutOff = preparedAt(path, 1.0, view).packed.cutOff;
    return renderPrepared(prepared, view, "auto").picture;
}

} // namespace

TEST_P(Scaling, ByPowersOfTwo_ChangesNoBit)
{
    const Picture usual = drawn(GetParam(), 1.0);
    for (const double s : {0x1p10, 0x1p-10}) {
        const Picture other = drawn(GetParam(), s);
        EXPECT_EQ(usual.floats, other.floats)
            << s << ": " << saveForTheEye("scaled-" + GetParam().stem().string(), other, usual);
    }
}
