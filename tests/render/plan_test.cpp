// Each feature, switched on in a scene of one object: its functions, uniforms and textures appear with it and
// vanish without.
#include "assembled.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

struct Toggle {
    std::string feature;             // of the plan
    std::string scene;               // has it
    std::vector<std::string> tokens; // of the shader's text: there with it, not there without
};

void PrintTo(const Toggle& toggle, std::ostream* stream)
{
    *stream << toggle.feature;
}

const std::string plain = "[camera]\neye = [0, 0, 5]\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";

std::string with(const std::string& material, const std::string& rest = "")
{
    return rest + "[material.m]\n" + material +
           "\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
}

const std::string point = "[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n";

std::string animated(const std::string& path, const std::string& values)
{
    return plain + "[[animate]]\npath = \"" + path + "\"\ntimes = [0, 1]\nvalues = " + values + "\n";
}

const std::vector<Toggle> toggles = {
    {"open cylinder",
     "[[cylinder]]\nbase = [0, 0, 0]\naxis = [0, 1, 0]\nradius = 1\n",
     {"openCylinderCrossing", "bool side"}},
    {"capped cylinder",
     "[[cylinder]]\nbase = [0, 0, 0]\naxis = [0, 1, 0]\nradius = 1\ncapped = true\n",
     {"cappedCylinderEntry", "slabSpan"}},
    {"plane", "[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n", {"planeCrossing"}},
    {"disk", "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 0, 1]\nradius = 1\n", {"diskCrossing"}},
    {"rectangle",
     "[[rectangle]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\n",
     {"rectangleCrossing"}},
    {"triangle",
     "[[triangle]]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n",
     {"triangleCrossing", "edgeSide"}},
    {"picture",
     with("image = \"planet.png\"", point),
     {"u_pictures0", "pictureColour", "latLong", "travelled"}},
    {"checker",
     with("pattern = \"checker\"\ncolours = [[1, 1, 1], [0, 0, 0]]\nsize = 1.0", point),
     {"checkerField", "latLong"}},
    {"emission", with("emission = [1, 1, 1]"), {"local + material.emission"}},
    {"mirror", with("mirror = 0.5"), {"traceChain", "u_budget", "u_cut_off", "vec3 mirrored"}},
    {"refraction",
     with("transmit = 1.0\nior = 1.5"),
     {"fresnelReflectance", "refractedDirection", "traceHeaviestFirst"}},
    {"absorption", with("transmit = 1.0\nior = 1.5\nabsorption = [1, 0, 0]"), {"path.medium"}},
    {"ambient light", with("", "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"), {"u_ambient"}},
    {"directional light",
     with("", "[[light]]\nkind = \"directional\"\ndirection = [0, -1, 0]\n"),
     {"u_lights[0]", "directionalIncidence"}},
    {"point light", with("", point), {"u_lights[0]", "pointIncidence(", "attenuation("}},
    {"spot light",
     with("", "[[light]]\nkind = \"spot\"\nposition = [0, 9, 0]\ndirection = [0, -1, 0]\ncutoff_deg = 20\n"),
     {"u_lights[0]", "spotIncidence(", "coneStrength"}},
    {"ambient part of placed lights",
     with("", point + "ambient = [1, 1, 1]\n"),
     {"light.ambient.xyz * ambientColour"}},
    {"glowing sphere", with("emission = [1, 1, 1]\nlight = true"), {"u_lights[0]", "glowing == 0"}},
    {"Phong highlight", with("model = \"phong\"\nspecular = [1, 1, 1]", point), {"phongLobe", "cosinePower"}},
    {"Blinn highlight", with("model = \"blinn\"\nspecular = [1, 1, 1]", point), {"blinnLobe", "cosinePower"}},
    {"shadows", with("", point), {"lightThrough"}},
    {"tinted shadows", with("transmit = 0.5", point), {"solidTint"}},
    {"absorption in shadows", with("transmit = 0.5\nabsorption = [1, 0, 0]", point), {"chordTransmittance"}},
    {"sky gradient", with("", "[sky]\ngradient = [[0, 0, 0], [1, 1, 1], [0, 0, 1]]\n"), {"u_sky.horizon"}},
    {"sky picture", with("", "[sky]\nimage = \"sky.exr\"\n"), {"u_sky_picture", "latLong"}},
    {"arctangent by polynomial", with("", "[sky]\nimage = \"sky.exr\"\n"), {"0.999996126"}},
    {"depth limit", with("mirror = 0.5", "[trace]\ndepth = 3\n"), {"u_depth", "bounces"}},
    {"solids seen from within", with("transmit = 0.5"), {"sphereCrossing"}},
    {"ray queue", with("mirror = 0.5", "[trace]\norder = \"breadth-first\"\n"), {"traceBreadthFirst"}},
    {"animation", animated("camera.eye.0", "[0, 1]"), {}},
    {"moving geometry", animated("sphere.0.radius", "[1, 2]"), {"MovingBlock", "u_moving[0].anchor.w"}},
    {"ray stack", with("mirror = 0.5", "[trace]\norder = \"depth-first\"\n"), {"traceDepthFirst"}},
    {"compensated kernels",
     plain + "[[disk]]\ncentre = [1e5, 0, 4.9]\nnormal = [0, 0, 1]\nradius = 2e5\n",
     {"fineDiskCrossing", "twoProduct", "chosenPosition", "u_one"}},
    {"kernels by curvature",
     plain + "[[sphere]]\ncentre = [0, -1e6, 5]\nradius = 999999.9\n",
     {"curvedSphereCrossing", "spanOfQuadratic", "chosenNormal", "u_one"}},
    {"geometry table", with("", "[trace]\nform = \"loop\"\n"), {"ShapeBlock", "crossingOf"}},
};

class PlanFeature : public testing::TestWithParam<Toggle>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Toggles, PlanFeature, testing::ValuesIn(toggles), [](const auto& info) {
    std::string name = info.param.feature;
    std::erase(name, ' ');
    return name;
});

TEST_P(PlanFeature, WithIt_ItsCodeIsThere)
{
    const auto shader = assembled(GetParam().scene);
    EXPECT_TRUE(shader.plan.has(GetParam().feature)) << shader.plan.feature(GetParam().feature).reason;
    EXPECT_FALSE(shader.plan.feature(GetParam().feature).reason.empty());
    for (const auto& token : GetParam().tokens)
        EXPECT_NE(shader.fragment.find(token), std::string::npos) << token << " is missing from\n"
                                                                  << shader.fragment;
}

TEST_P(PlanFeature, WithoutIt_NothingOfItIsLeft)
{
    const auto shader = assembled(plain);
    EXPECT_FALSE(shader.plan.has(GetParam().feature));
    for (const auto& token : GetParam().tokens)
        EXPECT_EQ(shader.fragment.find(token), std::string::npos) << token << " is still in\n"
                                                                  << shader.fragment;
}

TEST(Plan, UnusedMaterialsAndPictures_AreNeitherLoadedNorUploaded)
{
    const auto plan = assembled("[material.idle]\nimage = \"planet.png\"\n" + plain).plan;
    EXPECT_TRUE(plan.pictures.empty());
    EXPECT_EQ(plan.materials.size(), 1U);
}

TEST(Plan, WhereNothingShines_NoPictureIsLoadedAndNoSurfaceShaded)
{
    const auto shader = assembled(with("image = \"planet.png\""));
    EXPECT_TRUE(shader.plan.pictures.empty());
    EXPECT_FALSE(shader.plan.has("local shading"));
    EXPECT_EQ(shader.fragment.find("localRadiance"), std::string::npos);
}

TEST(Plan, UnlitSceneOfOneSphere_HasNoLightCodeAtAll)
{
    const auto shader = assembled("[trace]\nlight_type = 0\n" + with("", point));
    EXPECT_FALSE(shader.plan.has("point light"));
    EXPECT_EQ(shader.fragment.find("u_lights"), std::string::npos);
    EXPECT_NE(shader.fragment.find("u_ambient"), std::string::npos);
}

TEST(Plan, NestedMedia_GetALargerBudgetAndPool)
{
    const auto plan = assembled("[material.water]\ntransmit = 1.0\nior = 1.33\n"
                                "[material.glass]\ntransmit = 1.0\nior = 1.5\noutside = \"water\"\n"
                                "[[sphere]]\ncentre = [0, 0, 0]\nradius = 2\nmaterial = \"water\"\n"
                                "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"glass\"\n")
                          .plan;
    EXPECT_EQ(plan.budget, 24);
    EXPECT_EQ(plan.poolSlots, 4);
}

TEST(Plan, MediaAroundMedia_AreAllOfThePlan)
{
    const std::string a = "[material.a]\ntransmit = 1.0\nior = 1.5\noutside = \"b\"\n";
    const std::string b = "[material.b]\ntransmit = 1.0\nior = 1.4\noutside = \"c\"\n";
    const std::string c = "[material.c]\ntransmit = 1.0\nior = 1.3\n";
    const std::string ball = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"a\"\n";
    EXPECT_EQ(assembled(a + b + c + ball).plan.materials.size(), 3U);
    EXPECT_EQ(assembled(c + b + a + ball).plan.materials.size(), 3U);
}

TEST(Plan, ArctangentBuiltIn_LeavesThePolynomialOut)
{
    const std::string sky = "[sky]\nimage = \"sky.exr\"\n";
    const std::string builtIn = "[plan]\narctangent = \"built-in\"\n";
    for (const std::string force : {"", "force = \"all\"\n"}) {
        const auto [plan, text, vertex] = assembled(builtIn + force + with("", sky));
        EXPECT_FALSE(plan.has("arctangent by polynomial"));
        EXPECT_EQ(plan.feature("arctangent by polynomial").reason, "plan.arctangent is built-in");
        EXPECT_NE(text.find("return atan(y, x);"), std::string::npos);
        EXPECT_EQ(text.find("0.999996126"), std::string::npos);
    }
    EXPECT_EQ(assembled(sky + plain).fragment.find("return atan("), std::string::npos);
    EXPECT_EQ(assembled(builtIn + plain).plan.feature("arctangent by polynomial").reason,
              "no longitude is asked for");
}

TEST(Plan, OfTheStillLife_IsTheSameText_AsWithPlainKernelsAlone)
{
    const auto text =
        readSceneText(std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl/scenes/still_life.toml");
    const auto usual = assembled(text);
    const auto plainKernels = assembled(text + "\n[plan]\nkernels = \"plain\"\n");
    EXPECT_FALSE(usual.plan.choosesKernels());
    EXPECT_EQ(usual.fragment, plainKernels.fragment);
    EXPECT_EQ(usual.vertex, plainKernels.vertex);
    EXPECT_EQ(plainKernels.plan.feature("compensated kernels").reason, "plan.kernels is plain");
}

TEST(Plan, WhereADriversSumsAreNotExact_PlainKernelsStandInForCompensatedOnes)
{
    const Scene scene =
        parseScene(plain + "[[disk]]\ncentre = [1e5, 0, 4.9]\nnormal = [0, 0, 1]\nradius = 2e5\n"
                           "[[sphere]]\ncentre = [0, -1e6, 5]\nradius = 999999.9\n",
                   "text.toml");
    const auto curved = KernelForm::curved, compensated = KernelForm::compensated, usual = KernelForm::plain;
    const auto formsOf = [&](Guard guard) {
        return makePlan(scene, DataView::none, ShaderDevice{mostSharedVectors, guard}).kernels;
    };
    EXPECT_EQ(formsOf(Guard::unit), (std::vector{usual, compensated, curved}));
    EXPECT_EQ(formsOf(Guard::none), (std::vector{usual, usual, curved}));
    const Plan none = makePlan(scene, DataView::none, ShaderDevice{mostSharedVectors, Guard::none});
    EXPECT_NE(none.feature("compensated kernels").reason.find("not exact"), std::string::npos);
    EXPECT_FALSE(none.defines.contains("HAS_UNIT"));
    EXPECT_TRUE(makePlan(scene, DataView::none, ShaderDevice{mostSharedVectors, Guard::precise})
                    .defines.contains("HAS_PRECISE"));
}

TEST(Plan, PoolAlways_TakesAPoolOf4WhateverTheSurfacesDo)
{
    const std::string always = "[plan]\npool = \"always\"\n";
    const std::string surfaces[] = {"", "mirror = 0.5", "transmit = 0.5\nior = 1.5"};
    const RayTree byNeed[] = {RayTree::single, RayTree::chain, RayTree::heaviestFirst};
    for (std::size_t i = 0; i < std::size(surfaces); ++i) {
        EXPECT_EQ(assembled(with(surfaces[i])).plan.tree, byNeed[i]) << surfaces[i];
        const auto [plan, text, vertex] = assembled(always + with(surfaces[i]));
        EXPECT_EQ(plan.tree, RayTree::heaviestFirst) << surfaces[i];
        EXPECT_EQ(plan.feature("ray pool").reason, "4 slots: plan.pool is always") << surfaces[i];
        EXPECT_NE(text.find("#define POOL_SLOTS 4"), std::string::npos) << surfaces[i];
    }
    EXPECT_EQ(assembled(always + plain).plan.feature("refraction").reason, "plan.pool is always");
}

TEST(Plan, PoolAlways_GivesWayWhereNoneIsOfUse)
{
    const std::string always = "[plan]\npool = \"always\"\n";
    const auto queue = assembled(always + "[trace]\norder = \"breadth-first\"\n" + with("mirror = 0.5")).plan;
    EXPECT_EQ(queue.tree, RayTree::breadthFirst);
    EXPECT_FALSE(queue.has("refraction"));
    const auto oneRay = assembled(always + "[trace]\nbudget = 1\n" + with("mirror = 0.5")).plan;
    EXPECT_EQ(oneRay.tree, RayTree::single);
    EXPECT_FALSE(oneRay.has("refraction"));
    EXPECT_EQ(assembled(always).plan.tree, RayTree::single);
}
