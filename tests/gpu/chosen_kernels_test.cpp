// Objects whose kernels the plan chooses for precision: huge against the eye's distance to them. In single
// precision they are drawn as in double, where plain kernels are not.
#include "render/assemble.h"
#include "scene/load.h"
#include "support/compare.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// The ground's up is (0.28, 0.96, 0); it passes through the world's origin, near which beads of millimetres
// lie, seen from six centimetres: one mirrors, one is of glass, and all cast shadows.
const std::string beads = R"(
[camera]
eye = [0.0056, 0.0192, 0.060]
target = [0.00084, 0.00288, 0.0]
fov_y_deg = 36.0
[sky]
gradient = [[0.10, 0.12, 0.14], [0.75, 0.80, 0.85], [0.16, 0.34, 0.72]]
[material.ground]
colour = [0.55, 0.42, 0.30]
mirror = 0.1
[material.red]
colour = [0.7, 0.08, 0.05]
[material.chrome]
colour = [0.0, 0.0, 0.0]
mirror = 0.9
[material.glass]
transmit = 0.95
ior = 1.5
[[light]]
kind = "ambient"
ambient = [0.35, 0.35, 0.4]
[[light]]
kind = "directional"
direction = [-0.5, -0.7, -0.35]
[[light]]
kind = "point"
position = [0.02, 0.05, 0.03]
diffuse = [0.2, 0.2, 0.2]
[[sphere]]
centre = [0.0014, 0.0048, 0.0]
radius = 0.005
material = "chrome"
[[sphere]]
centre = [-0.008, 0.0055, 0.004]
radius = 0.003
material = "red"
[[sphere]]
centre = [0.0095, 0.0012, 0.002]
radius = 0.004
material = "glass"
)";

struct Ground {
    const char* name;
    KernelForm form;
    const char* toml;
};

void PrintTo(const Ground& ground, std::ostream* out)
{
    *out << ground.name;
}

const Ground grounds[] = {
    {"Planet", KernelForm::curved, "[[sphere]]\ncentre = [-2.8e6, -9.6e6, 0]\nradius = 1e7\n"},
    {"Hill", KernelForm::compensated, "[[sphere]]\ncentre = [-14, -48, 0]\nradius = 50\n"},
    {"Bowl", KernelForm::curved, "[[sphere]]\ncentre = [280, 960, 0]\nradius = 1000\n"},
    {"OpenVault", KernelForm::curved,
     "[[cylinder]]\nbase = [-2.8e5, -9.6e5, -1e5]\naxis = [0, 0, 2e5]\nradius = 1e6\n"},
    {"CappedVault", KernelForm::curved,
     "[[cylinder]]\nbase = [-2.8e5, -9.6e5, -1e5]\naxis = [0, 0, 2e5]\nradius = 1e6\ncapped = true\n"},
    {"OpenHill", KernelForm::compensated,
     "[[cylinder]]\nbase = [-28, -96, -100]\naxis = [0, 0, 200]\nradius = 100\n"},
    {"CappedHill", KernelForm::compensated,
     "[[cylinder]]\nbase = [-28, -96, -100]\naxis = [0, 0, 200]\nradius = 100\ncapped = true\n"},
    {"Cap", KernelForm::compensated,
     "[[cylinder]]\nbase = [-28, -96, 0]\naxis = [28, 96, 0]\nradius = 1e6\ncapped = true\n"},
    {"Plane", KernelForm::compensated, "[[plane]]\npoint = [9.6e6, -2.8e6, 1e6]\nnormal = [0.28, 0.96, 0]\n"},
    {"Disk", KernelForm::compensated,
     "[[disk]]\ncentre = [4.8e5, -1.4e5, 3e5]\nnormal = [0.28, 0.96, 0]\nradius = 1e6\n"},
    {"Rectangle", KernelForm::compensated,
     "[[rectangle]]\ncorner = [-9.6e5, 2.8e5, 1e6]\nedge_u = [1.92e6, -5.6e5, 0]\nedge_v = [0, 0, -1.7e6]\n"},
    {"Triangle", KernelForm::compensated,
     "[[triangle]]\na = [-9.6e5, 2.8e5, 1e6]\nb = [1.92e6, -5.6e5, 9e5]\nc = [0, 0, -1.7e6]\n"}};

class Grounds : public testing::TestWithParam<Ground>
{
public:
    std::string scene() const
    {
        return beads + GetParam().toml + "name = \"ground\"\nmaterial = \"ground\"\n";
    }
};

INSTANTIATE_TEST_SUITE_P(Of, Grounds, testing::ValuesIn(grounds),
                         [](const auto& info) { return std::string(info.param.name); });

// What the gallery's pictures may differ by between single and double precision, too.
constexpr double mostRmse = 0.002;

} // namespace

TEST_P(Grounds, NearTheEye_LookInSinglePrecisionAsInDouble)
{
    const Scene parsed = parseScene(scene(), "text.toml");
    EXPECT_EQ(makePlan(parsed).kernels.back(), GetParam().form);
    EXPECT_EQ(makePlan(parsed).kernels.front(), KernelForm::plain) << "a bead is ordinary";
    const Picture twice = renderDoubleText(scene(), {160, 90, 1, {}, "auto"});
    for (const char* form : {"literal", "loop"}) {
        const Request request{160, 90, 1, {std::string("trace.form=") + form}, "auto"};
        const Picture single = renderSceneText(scene(), request).picture;
        const auto difference = compare(single, twice, 0.01);
        std::cout << GetParam().name << ", " << form << ": RMSE " << difference.rmse << ", "
                  << difference.over << " pixels over 0.01\n";
        EXPECT_LT(difference.rmse, mostRmse)
            << saveForTheEye(std::string("chosen-") + GetParam().name, single, twice);
        EXPECT_LE(difference.over, difference.pixels / 200);
    }
}

// Measured 300 times as far off at the least, and half a million times on the planet.
TEST_P(Grounds, AreATenthAsFarOffAsByPlainKernels_AtMost)
{
    const Request request{160, 90, 1, {}, "auto"};
    const Picture twice = renderDoubleText(scene(), request);
    const auto rmseOf = [&](const char* kernels) {
        const Request by{160, 90, 1, {std::string("plan.kernels=") + kernels}, "auto"};
        return compare(renderSceneText(scene(), by).picture, twice, 0.01).rmse;
    };
    const double plain = rmseOf("plain");
    std::cout << GetParam().name << " by plain kernels: RMSE " << plain << "\n";
    EXPECT_LT(rmseOf("auto"), 0.1 * plain);
}

TEST(ChosenKernels, OfAnObjectThatMoves_AreChosenToo)
{
    const std::string scene =
        beads + "[[disk]]\nname = \"ground\"\ncentre = [4.8e5, -1.4e5, 3e5]\n"
                "normal = [0.28, 0.96, 0]\nradius = 1e6\nmaterial = \"ground\"\n"
                "[[sphere]]\nname = \"planet\"\ncentre = [-2.8e6, -9.6e6, 0]\nradius = 9999999\n"
                "[[animate]]\npath = \"planet.centre.2\"\ntimes = [0, 1]\nvalues = [0, 100]\n"
                "[[animate]]\npath = \"ground.centre.2\"\ntimes = [0, 1]\nvalues = [3e5, 3.1e5]\n";
    for (const char* form : {"literal", "loop"}) {
        const Request request{160, 90, 1, {std::string("trace.form=") + form}, "auto", 0.3};
        const Picture single = renderSceneText(scene, request).picture;
        const Picture twice = renderDoubleText(scene, request);
        EXPECT_LT(compare(single, twice, 0.01).rmse, mostRmse)
            << saveForTheEye("chosen-moving", single, twice);
    }
}
