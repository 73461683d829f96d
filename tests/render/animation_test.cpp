// An animated scene has one plan and one shader, whatever the time: values change, the text does not.
#include "render/assemble.h"
#include "render/pack.h"
#include "render/prepare.h"
#include "scene/load.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

const std::filesystem::path glsl = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";

PreparedScene preparedAt(const std::string& toml, double time_s)
{
    return prepare(parseScene(toml, glsl / "scenes" / "text.toml", {}, time_s), {64, 36, 1, glsl});
}

std::string shaderAt(const std::string& toml, double time_s)
{
    const auto prepared = preparedAt(toml, time_s);
    return flatten(assemble(prepared.scene, prepared.plan, prepared.packed, glsl));
}

std::string animate(const std::string& path, const std::string& values)
{
    return "[[animate]]\npath = \"" + path + "\"\ntimes = [0, 1, 2]\nvalues = " + values + "\n";
}

std::string planText(const Plan& plan)
{
    std::string text;
    for (const auto& feature : plan.features)
        text += feature.name + (feature.in ? " in: " : " out: ") + feature.reason + "\n";
    return text + std::to_string(plan.budget) + " " + std::to_string(plan.poolSlots);
}

void expectOneShader(const std::string& toml)
{
    const auto text = shaderAt(toml, 0.0);
    const auto plan = planText(preparedAt(toml, 0.0).plan);
    for (const double time_s : {-1.0, 0.5, 1.0, 1.7, 2.0, 9.0}) {
        EXPECT_EQ(shaderAt(toml, time_s), text) << time_s;
        EXPECT_EQ(planText(preparedAt(toml, time_s).plan), plan) << time_s;
    }
}

const std::string lit = "[camera]\neye = [0, 1, 5]\n[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"
                        "[material.m]\n[material.n]\n";
const std::string balls = "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n"
                          "[[sphere]]\ncentre = [3, 0, 0]\nradius = 1\nmaterial = \"n\"\n";

bool hasAtAllTimes(const std::string& toml, const std::string& feature)
{
    const bool has = preparedAt(toml, 0.0).plan.has(feature);
    for (const double time_s : {-1.0, 0.5, 1.0, 2.0, 9.0})
        EXPECT_EQ(preparedAt(toml, time_s).plan.has(feature), has) << feature << " at " << time_s;
    return has;
}

// Every shape, every part of it moving.
std::string everyShape(const std::string& form)
{
    const std::string flat = "[[0, 1, 0], [0, 1, 1], [0, 0, 1]]";
    const std::string glass = "material = \"glass\"\n";
    return "[trace]\nform = \"" + form + "\"\n" + lit + "[material.glass]\ntransmit = 1.0\nior = 1.5\n" +
           balls + "[[cylinder]]\nbase = [0, 0, 0]\naxis = [0, 1, 0]\nradius = 1\n" +
           "[[cylinder]]\nbase = [2, 0, 0]\naxis = [0, 1, 0]\nradius = 1\ncapped = true\n" + glass +
           "[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n" + glass +
           "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 1\n" +
           "[[rectangle]]\ncorner = [0, 0, 0]\nedge_u = [1, 0, 0]\nedge_v = [0, 1, 0]\n" +
           "[[triangle]]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n" +
           animate("ball.centre.1", "[0, 2, 1]") + animate("cylinder.0.radius", "[1, 2, 1]") +
           animate("cylinder.1.axis", flat) + animate("plane.0.normal", flat) +
           animate("disk.0.normal", flat) + animate("rectangle.0.edge_v", flat) +
           animate("triangle.0.c", flat) + animate("sphere.1.rotate_texture_deg", "[0, 90, 0]");
}

} // namespace

TEST(Animation, MovingShapes_AreUniformsInOneShader)
{
    expectOneShader(everyShape("literal"));
    const auto text = shaderAt(everyShape("literal"), 0.0);
    EXPECT_NE(text.find("Shape u_moving[MOVING_COUNT]"), std::string::npos);
    EXPECT_NE(text.find("#define MOVING_COUNT 8"), std::string::npos);
    for (const char* call :
         {"sphereCrossing(ray, 0, u_moving[0].anchor.xyz, u_moving[0].anchor.w)",
          "openCylinderCrossing(ray, 2, u_moving[2].anchor.xyz, u_moving[2].axis.xyz, u_moving[2].anchor.w, "
          "u_moving[2].axis.w)",
          "planeTint(planeCrossing(ray, 4, u_moving[4].anchor.xyz, u_moving[4].axis.xyz), ray, distance, "
          "u_moving[4].anchor.xyz",
          "triangleCrossing(ray, 7, u_moving[7].anchor.xyz, u_moving[7].along_u.xyz"})
        EXPECT_NE(text.find(call), std::string::npos) << call << " is missing from\n" << text;
}

TEST(Animation, MovingShapes_InATable_NeedNoOtherUniforms)
{
    expectOneShader(everyShape("loop"));
    EXPECT_EQ(shaderAt(everyShape("loop"), 0.0).find("u_moving"), std::string::npos);
}

TEST(Animation, StillObjectsAmongMovingOnes_StayConstants)
{
    const auto text = shaderAt(lit + balls + animate("ball.centre.1", "[0, 2, 1]"), 0.0);
    EXPECT_NE(text.find("sphereCrossing(ray, 1, vec3(3.0, 0.0, 0.0), 1.0)"), std::string::npos) << text;
}

TEST(Animation, CameraThatTravelsFar_LeavesTheConstantsAsTheyAre)
{
    expectOneShader(lit + balls + animate("camera.eye", "[[0, 1, 5], [9000, 1, 5], [0, 1, 900000]]"));
}

TEST(Animation, CameraLightsSkyAndMaterials_AreUniformsInOneShader)
{
    expectOneShader(
        "[sky]\ngradient = [[0, 0, 0], [1, 1, 1], [2, 2, 2]]\n" + lit +
        "[[light]]\nkind = \"spot\"\nposition = [0, 5, 0]\ndirection = [0, -1, 0]\ncutoff_deg = 30\n"
        "[material.checker]\npattern = \"checker\"\ncolours = [[1, 1, 1], [0, 0, 0]]\nsize = 1\n" +
        balls + "[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = \"checker\"\n" +
        animate("camera.target", "[[0, 0, 0], [1, 0, 0], [0, 0, 0]]") +
        animate("camera.fov_y_deg", "[20, 30, 40]") + animate("sky.gradient.0.1", "[0, 1, 2]") +
        animate("light.0.attenuation", "[[1, 0, 0], [0, 0, 1], [0, 1, 0]]") +
        animate("light.1.cutoff_deg", "[10, 20, 30]") +
        animate("light.1.specular", "[[0, 0, 0], [1, 0, 1], [0, 1, 0]]") +
        animate("material.checker.size", "[1, 2, 1]") +
        animate("material.checker.colours.1", "[\"#000000\", \"#123456\", \"#000000\"]") +
        animate("material.m.emission", "[[0, 0, 0], [0, 1, 0], [0, 0, 0]]") +
        animate("material.n.transmit", "[0, 0, 1]"));
}

TEST(Animation, FeatureOfOneKeyAlone_IsInAtAllTimes)
{
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("material.m.mirror", "[0, 0, 1]"), "mirror"));
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("material.m.transmit", "[0, 0.1, 0]"), "refraction"));
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("material.m.transmit", "[0, 0.1, 0]"), "tinted shadows"));
    EXPECT_TRUE(hasAtAllTimes(
        lit + balls + animate("material.m.emission", "[[0, 0, 0], [0, 0, 0], [0, 1, 0]]"), "emission"));
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("light.0.ambient", "[[0, 0, 0], [0, 0, 1], [0, 0, 0]]"),
                              "ambient part of placed lights"));
    const std::string blinn = "[material.b]\nmodel = \"blinn\"\n[[disk]]\ncentre = [0, 0, 0]\n"
                              "normal = [0, 1, 0]\nradius = 1\nmaterial = \"b\"\n";
    EXPECT_TRUE(
        hasAtAllTimes(lit + blinn + animate("material.b.specular", "[[0, 0, 0], [0, 0, 0], [0, 1, 0]]"),
                      "Blinn highlight"));
}

TEST(Animation, FeatureOfNoKey_IsOut)
{
    EXPECT_FALSE(hasAtAllTimes(lit + balls + animate("material.m.mirror", "[0, 0, 0]"), "mirror"));
    // Mirrors at every key hide what glass would show.
    EXPECT_FALSE(hasAtAllTimes(lit + balls + animate("material.m.transmit", "[0, 1, 1]") +
                                   animate("material.m.mirror", "[1, 1, 1]"),
                               "refraction"));
    // Where all surfaces are mirrors at all times, no light is reckoned with.
    EXPECT_FALSE(hasAtAllTimes(lit + balls + animate("material.m.mirror", "[1, 1, 1]") +
                                   animate("material.n.mirror", "[1, 1, 1]"),
                               "local shading"));
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("material.m.mirror", "[1, 1, 1]") +
                                  animate("material.n.mirror", "[1, 0.5, 1]"),
                              "local shading"));
}

TEST(Animation, FeatureThatNeedsTwoValues_IsInWhereTheyMeetBetweenKeys)
{
    // At 0 s and 2 s nothing is transmitted, at 1 s all is mirrored; at 1.5 s half is glass.
    expectOneShader(lit + balls + animate("material.m.transmit", "[0, 1, 0]") +
                    animate("material.m.mirror", "[1, 1, 0]"));
    EXPECT_TRUE(hasAtAllTimes(lit + balls + animate("material.m.transmit", "[0, 1, 0]") +
                                  animate("material.m.mirror", "[1, 1, 0]"),
                              "refraction"));
}

TEST(Animation, LightType_HoldsForThePlanToo)
{
    const std::string ambient = animate("light.0.ambient", "[[0, 0, 0], [0, 0, 1], [0, 0, 0]]");
    for (const char* type : {"0", "2"}) {
        const auto toml = "[trace]\nlight_type = " + std::string(type) + "\n" + lit + balls + ambient;
        expectOneShader(toml);
        EXPECT_FALSE(hasAtAllTimes(toml, "ambient part of placed lights"));
    }
}

TEST(Animation, Gallery_HasOneShaderAScene)
{
    for (const auto& entry : std::filesystem::directory_iterator(glsl / "scenes")) {
        if (entry.path().extension() != ".toml")
            continue;
        std::string text;
        for (const double time_s : {0.0, 1.3, 4.7}) {
            const auto prepared = prepare(loadScene(entry.path(), {}, time_s, {{}, glsl}), {64, 36, 1, glsl});
            const auto now = flatten(assemble(prepared.scene, prepared.plan, prepared.packed, glsl));
            EXPECT_TRUE(text.empty() || now == text) << entry.path() << " at " << time_s;
            text = now;
        }
    }
}

TEST(Animation, ManyAnimatedValues_AreCountedAndTheFirstFewNamed)
{
    const auto reasonOf = [](const std::string& animations) {
        return preparedAt(lit + balls + animations, 0.0).plan.feature("animation").reason;
    };
    const auto one = animate("ball.radius", "[1, 2, 1]");
    EXPECT_EQ(reasonOf(one), "1 value: ball.radius");
    const auto three = one + animate("ball.centre.0", "[1, 2, 1]") + animate("ball.centre.1", "[1, 2, 1]");
    EXPECT_EQ(reasonOf(three), "3 values: ball.radius, ball.centre.0, ball.centre.1");
    EXPECT_EQ(reasonOf(three + animate("ball.centre.2", "[1, 2, 1]")),
              "4 values: ball.radius, ball.centre.0, ball.centre.1, …");
}
