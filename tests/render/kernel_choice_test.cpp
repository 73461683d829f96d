// How far a surface is from a point, and which kernels that asks for.
#include "render/kernel_choice.h"
#include "render/latch.h"
#include "render/plan.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

using namespace dioptre;

namespace
{

using glm::dvec3;

class Places
{
public:
    double share()
    {
        return static_cast<double>(random_()) / 4294967296.0;
    }
    dvec3 inCube(double half)
    {
        const double x = share(), y = share(), z = share();
        return half * (2.0 * dvec3(x, y, z) - 1.0);
    }
    // Cosine and sine of any angle.
    glm::dvec2 turn()
    {
        const double angle = 2.0 * std::numbers::pi * share();
        return {std::cos(angle), std::sin(angle)};
    }

private:
    std::mt19937 random_{7};
};

// A point of the surface; shapes stand upright, so that none of distanceTo()'s own ways is gone.
dvec3 onSurface(const Primitive& primitive, Places& places)
{
    const auto turn = places.turn();
    const double u = places.share(), v = places.share();
    if (const auto* sphere = std::get_if<Sphere>(&primitive)) {
        const double z = 2.0 * u - 1.0, aside = std::sqrt(1.0 - z * z);
        return sphere->centre + sphere->radius * dvec3(aside * turn.x, z, aside * turn.y);
    }
    if (const auto* cylinder = std::get_if<Cylinder>(&primitive)) {
        const dvec3 around(turn.x, 0.0, turn.y);
        if (cylinder->capped && places.share() < 0.5)
            return cylinder->base + (u < 0.5 ? dvec3(0.0) : cylinder->axis) +
                   cylinder->radius * std::sqrt(v) * around;
        return cylinder->base + v * cylinder->axis + cylinder->radius * around;
    }
    if (const auto* plane = std::get_if<Plane>(&primitive))
        return plane->point + 6.0 * dvec3(2.0 * u - 1.0, 0.0, 2.0 * v - 1.0);
    if (const auto* disk = std::get_if<Disk>(&primitive))
        return disk->centre + disk->radius * std::sqrt(v) * dvec3(turn.x, 0.0, turn.y);
    if (const auto* rectangle = std::get_if<Rectangle>(&primitive))
        return rectangle->corner + u * rectangle->edgeU + v * rectangle->edgeV;
    const auto& triangle = std::get<Triangle>(primitive);
    const bool over = u + v > 1.0;
    return triangle.a + (over ? 1.0 - u : u) * (triangle.b - triangle.a) +
           (over ? 1.0 - v : v) * (triangle.c - triangle.a);
}

const std::vector<Primitive> shapes = {Sphere{{0.2, 0.1, -0.3}, 1.1},
                                       Cylinder{{0.1, -0.5, 0.2}, {0.0, 1.2, 0.0}, 0.8, false},
                                       Cylinder{{0.1, -0.5, 0.2}, {0.0, 1.2, 0.0}, 0.8, true},
                                       Plane{{0.3, 0.2, 0.1}, {0.0, 2.0, 0.0}, {}},
                                       Disk{{0.1, 0.2, -0.1}, {0.0, -3.0, 0.0}, 1.3},
                                       Rectangle{{-0.6, -0.3, 0.2}, {1.4, 0.2, 0.1}, {0.3, 0.9, -0.5}},
                                       Triangle{{-0.6, -0.3, 0.2}, {1.0, 0.4, 0.3}, {-0.2, 0.9, -0.6}}};

// A scene of one object that is `away` metres from the eye, above it.
KernelForm formOf(const std::string& object, double away)
{
    const Scene scene = parseScene(
        "[camera]\neye = [0, " + std::to_string(away) + ", 0]\ntarget = [0, 0, -1]\n" + object, "text.toml");
    return makePlan(scene).kernels.front();
}

} // namespace

TEST(DistanceTo, IsThatOfTheNearestOfManyPoints)
{
    Places places;
    for (const auto& shape : shapes)
        for (int i = 0; i < 40; ++i) {
            const dvec3 eye = places.inCube(2.0);
            double nearest = 1e9;
            for (int k = 0; k < 40000; ++k)
                nearest = std::min(nearest, glm::distance(eye, onSurface(shape, places)));
            const double distance = distanceTo(shape, eye);
            // 40,000 points lie about 0.02 apart, or 0.07 on the piece of plane: the nearest is further by no
            // more than that where the eye is near, and by a square of it elsewhere.
            EXPECT_LE(distance, nearest + 1e-12) << "shape " << shape.index();
            EXPECT_GT(distance, nearest - 0.08)
                << "shape " << shape.index() << ", eye " << eye.x << " " << eye.y << " " << eye.z;
        }
}

TEST(KernelChoice, GoesFromPlainToCompensatedToCurvature_AsTheEyeComesNear)
{
    const std::string planet = "[[sphere]]\ncentre = [0, -6e6, 0]\nradius = 6e6\n";
    EXPECT_EQ(formOf(planet, 6e6), KernelForm::plain);
    EXPECT_EQ(formOf(planet, 1e4), KernelForm::compensated);
    EXPECT_EQ(formOf(planet, 100.0), KernelForm::curved);
    EXPECT_EQ(formOf(planet, 0.0), KernelForm::curved);
    const std::string disk = "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 1e4\n";
    EXPECT_EQ(formOf(disk, 1e4), KernelForm::plain);
    EXPECT_EQ(formOf(disk, 1.0), KernelForm::compensated) << "a flat shape has no curvature";
    EXPECT_EQ(formOf(disk, 0.0), KernelForm::compensated);
}

// 8 units of rounding of |eye - c| + R + 2 e = 2 R + 3 e against a twentieth of a pixel at e: with fov 42
// degrees and 1,080 lines R = e (0.05 2 tan(21 deg) 2^24 / 8 / 1080 - 3) / 2 = 35.8 e.
TEST(KernelChoice, CompensatesFromATwentiethOfAPixel)
{
    const auto sphere = [](double radius) {
        return "[[sphere]]\ncentre = [0, " + std::to_string(-radius) +
               ", 0]\nradius = " + std::to_string(radius) + "\n";
    };
    EXPECT_EQ(formOf(sphere(35.0), 1.0), KernelForm::plain);
    EXPECT_EQ(formOf(sphere(37.0), 1.0), KernelForm::compensated);
}

TEST(KernelChoice, IsPlainThroughoutTheScenesOfOrdinaryNumbers)
{
    const std::filesystem::path glsl = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";
    for (const char* name : {"still_life", "glass", "mirrors", "underwater", "crowd", "textures", "lights"}) {
        const auto path = glsl / "scenes" / (std::string(name) + ".toml");
        const Plan plan = makePlan(loadScene(path, {}, 0.0, {{}, glsl}));
        EXPECT_FALSE(plan.choosesKernels()) << name << ": " << plan.feature("compensated kernels").reason;
    }
}

TEST(KernelChoice, UnderAMovingEye_IsMadeOnceAndKept)
{
    const auto from = [](double height) {
        return parseScene("[camera]\neye = [0, " + std::to_string(height) +
                              ", 5]\ntarget = [0, 0, 0]\n"
                              "[[sphere]]\ncentre = [0, -60, 0]\nradius = 60\n",
                          "text.toml");
    };
    const Scene above = from(60.0);
    EXPECT_FALSE(makePlan(above).choosesKernels());
    Scene near = from(0.5);
    latch(near, above);
    EXPECT_TRUE(makePlan(near).has("compensated kernels"));
    Scene again = from(60.0);
    latch(again, near);
    EXPECT_TRUE(makePlan(again).has("compensated kernels")) << "the shader stays";
    Scene back = from(0.5);
    latch(back, again);
    EXPECT_EQ(typicalOf(back).sights.size(), typicalOf(near).sights.size()) << "nothing is gathered twice";
}

TEST(KernelChoice, OfAnAnimation_ServesEveryKey)
{
    const std::string text =
        "[camera]\neye = [0, 60, 0]\ntarget = [0, 0, 1]\n"
        "[[sphere]]\ncentre = [0, -60, 0]\nradius = 60\n"
        "[[animate]]\npath = \"camera.eye.1\"\ntimes = [0, 1, 2]\nvalues = [60, 0.5, 60]\n";
    EXPECT_TRUE(makePlan(parseScene(text, "text.toml", {}, 0.0)).has("compensated kernels"));
    const std::string ball = "[camera]\neye = [0, 60, 0]\ntarget = [0, 0, 1]\n"
                             "[[sphere]]\nname = \"ball\"\ncentre = [0, -60, 0]\nradius = 60\n"
                             "[[animate]]\npath = \"ball.centre.1\"\ntimes = [0, 1]\nvalues = [-60, -0.5]\n";
    EXPECT_TRUE(makePlan(parseScene(ball, "text.toml", {}, 0.0)).has("compensated kernels"));
}

TEST(KernelChoice, OfAnAnimation_ServesTheWayFromKeyToKey)
{
    const std::string past = "[camera]\neye = [-90, 60, 0]\ntarget = [0, -60, 1]\n"
                             "[[sphere]]\ncentre = [0, -60, 0]\nradius = 119.5\n"
                             "[[animate]]\npath = \"camera.eye.0\"\ntimes = [0, 1]\nvalues = [-90, 90]\n";
    EXPECT_TRUE(makePlan(parseScene(past, "text.toml", {}, 0.0)).has("compensated kernels"));
}

TEST(KernelChoice, OfAnAnimationUnderEdits_ServesItsNewKeys)
{
    const auto flight = [](const std::string& low) {
        return parseScene("[camera]\neye = [0, 60, 0]\ntarget = [0, 0, 1]\n"
                          "[[sphere]]\ncentre = [0, -60, 0]\nradius = 60\n"
                          "[[animate]]\npath = \"camera.eye.1\"\ntimes = [0, 1]\nvalues = [60, " +
                              low + "]\n",
                          "text.toml");
    };
    const Scene high = flight("50");
    EXPECT_FALSE(makePlan(high).choosesKernels());
    Scene low = flight("0.5");
    latch(low, high);
    EXPECT_TRUE(makePlan(low).has("compensated kernels"));
}
