// Every key of a material and of a light reaches its field.
#include "scene/load.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

TEST(Scene, HexColour_IsDecodedFromSrgbAndNumbersAreLinear)
{
    const Scene scene = parseScene("[material.a]\ncolour = \"#FF0080\"\nspecular = [1, 0.5, 0]\n", "a.toml");
    EXPECT_EQ(scene.materials[0].colour.r, 1.0);
    EXPECT_EQ(scene.materials[0].colour.g, 0.0);
    EXPECT_NEAR(scene.materials[0].colour.b, 0.2158605, 1e-6); // ((128/255 + 0.055) / 1.055)^2.4
    EXPECT_EQ(scene.materials[0].specular, glm::dvec3(1.0, 0.5, 0.0));
}

TEST(Scene, EveryMaterialKey_ReachesItsField)
{
    const Scene scene = parseScene(R"([material.a]
model = "blinn"
ambient = [0, 0, 1]
specular = [1, 1, 1]
shininess = 8
mirror = 0.25
mirror_colour = [1, 0, 0]
transmit = 0.5
ior = 1.3
outside = "b"
emission = [2, 2, 2]
light = true
shadow = "none"
[material.b]
model = "microfacet"
roughness = 1e-4
metalness = 0.7
)",
                                   "a.toml");
    const Material& a = scene.materials[0];
    EXPECT_EQ(a.model, ReflectanceModel::blinn);
    EXPECT_EQ(a.ambient, glm::dvec3(0.0, 0.0, 1.0));
    EXPECT_EQ(a.specular, glm::dvec3(1.0));
    EXPECT_EQ(a.shininess, 8.0);
    EXPECT_EQ(a.mirror, 0.25);
    EXPECT_EQ(a.mirrorColour, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(a.transmit, 0.5);
    EXPECT_EQ(a.ior, 1.3);
    EXPECT_EQ(a.outside, 1u); // defined further down
    EXPECT_EQ(a.emission, glm::dvec3(2.0));
    EXPECT_TRUE(a.light);
    EXPECT_EQ(a.shadow, ShadowKind::none);
    const Material& b = scene.materials[1];
    EXPECT_FALSE(b.ambient);
    EXPECT_EQ(b.model, ReflectanceModel::microfacet);
    EXPECT_EQ(b.roughness, 1e-4);
    EXPECT_EQ(b.metalness, 0.7);
    EXPECT_EQ(b.specular, glm::dvec3(0.04)) << "of most plastics and glass";
}

TEST(Scene, EveryKindOfLight_HasItsValuesAndItsDefaults)
{
    const Scene scene = parseScene(R"([[light]]
kind = "ambient"
ambient = [0.1, 0.1, 0.1]
[[light]]
kind = "directional"
direction = [0, -1e-200, 0]
diffuse = [1, 0, 0]
[[light]]
kind = "spot"
position = [0, 5, 0]
direction = [3, 0, 4]
cutoff_deg = 30
exponent = 2
specular = "#000000"
[[light]]
kind = "point"
position = [1, 2, 3]
)",
                                   "a.toml");
    EXPECT_EQ(scene.lights[0].ambient, glm::dvec3(0.1));
    EXPECT_EQ(scene.lights[0].diffuse, glm::dvec3(0.0)); // from everywhere, so not from anywhere
    EXPECT_EQ(scene.lights[1].direction, glm::dvec3(0.0, -1.0, 0.0));
    EXPECT_EQ(scene.lights[1].specular, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(scene.lights[2].direction, glm::dvec3(0.6, 0.0, 0.8));
    EXPECT_EQ(scene.lights[2].specular, glm::dvec3(0.0));
    EXPECT_EQ(scene.lights[2].cutoff_deg, 30.0);
    EXPECT_EQ(scene.lights[3].attenuation, glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(scene.lights[3].ambient, glm::dvec3(0.0));
}

TEST(Scene, EveryOutputKey_ReachesItsField)
{
    const Scene scene = parseScene("[output]\nexposure = -1.5\ncurve = \"filmic\"\ngamma = 2.2\n", "a.toml");
    EXPECT_EQ(scene.output.exposure, -1.5);
    EXPECT_EQ(scene.output.curve, ToneCurve::filmic);
    EXPECT_EQ(scene.output.gamma, 2.2);
    EXPECT_FALSE(parseScene("[output]\ngamma = \"srgb\"\n", "a.toml").output.gamma);
    const Scene set = parseScene("", "a.toml", {"output.curve=reinhard"}); // a section that is not there
    EXPECT_EQ(set.output.curve, ToneCurve::reinhard);
    EXPECT_EQ(set.output.exposure, 0.0);
}

} // namespace

} // namespace dioptre
