// Objects whose kernels the plan chooses for precision: huge against the eye's distance to them. In single
// precision they are drawn as in double, where plain kernels are not.
#include "render/renderer.h"
#include "render/still.h"
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

namespace
{

// A planet under the beads that rises a little, and a wall behind them that comes nearer.
const std::string rising = beads + R"([[sphere]]
name = "planet"
centre = [-2.8e6, -9.6e6, 0]
radius = 1e7
material = "ground"
[[disk]]
name = "wall"
centre = [4.8e5, -1.4e5, -0.05]
normal = [0, 0, 1]
radius = 1e6
material = "ground"
[[animate]]
path = "planet.centre.1"
times = [0, 1]
values = [-9.6e6, -9599999.999]
[[animate]]
path = "wall.centre.2"
times = [0, 1]
values = [-0.05, -0.04]
)";

// Light through the water of a half-space whose point is far away.
const std::string water = beads + R"([material.water]
transmit = 1.0
ior = 1.33
absorption = [30, 10, 5]
[[plane]]
point = [9.6e6, -2.8e6, 1e6]
normal = [0.28, 0.96, 0]
material = "water"
[[disk]]
centre = [-0.0056, -0.0192, 0]
normal = [0.28, 0.96, 0]
radius = 0.05
material = "red"
)";

// What a few of its pixels, and no more, may show otherwise.
void expectAsInDouble(const std::string& scene, const Request& request)
{
    const Picture single = renderSceneText(scene, request).picture;
    const Picture twice = renderDoubleText(scene, request);
    EXPECT_LT(compare(single, twice, 0.01).rmse, mostRmse) << saveForTheEye("chosen", single, twice);
}

} // namespace

TEST(ChosenKernels, OfObjectsThatMove_AreCompensated)
{
    const Plan plan = makePlan(parseScene(rising, "text.toml", {}, 0.3));
    EXPECT_EQ(plan.kernels[plan.kernels.size() - 2], KernelForm::compensated)
        << "where it stands still it is curved";
    EXPECT_EQ(plan.kernels.back(), KernelForm::compensated);
    for (const char* form : {"trace.form=literal", "trace.form=loop"})
        expectAsInDouble(rising, {160, 90, 1, {form}, "auto", 0.3});
}

TEST(ChosenKernels, OfAPlaneWithAMediumBehind_DimLightByWhatIsBehind)
{
    EXPECT_TRUE(makePlan(parseScene(water, "text.toml")).has("compensated kernels"));
    for (const char* form : {"trace.form=literal", "trace.form=loop"})
        expectAsInDouble(water, {160, 90, 1, {form}, "auto"});
}

// Straight up the axis of a well 100 m wide, from near its wall.
TEST(ChosenKernels, AlongAnAxis_MeetTheCap)
{
    const std::string well =
        "[camera]\neye = [0.001, 1, 0]\ntarget = [0.001, 5, 0]\nfov_y_deg = 20\n"
        "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"
        "[[cylinder]]\nbase = [100, 0, 0]\naxis = [0, 9, 0]\nradius = 100\ncapped = true\n";
    EXPECT_TRUE(makePlan(parseScene(well, "text.toml")).has("kernels by curvature"));
    const Picture picture = renderSceneText(well, {33, 33, 1, {}, "auto"}).picture;
    EXPECT_EQ(picture.floats[4 * (33 * 16 + 16)], 1.0F) << "the very middle";
    expectAsInDouble(well, {33, 33, 1, {}, "auto"});
}

namespace
{

// The scene as a driver would draw it whose sums are guarded otherwise, in parts or whole.
Picture underGuard(const std::string& toml, Guard guard, const std::vector<std::string>& overrides)
{
    const ViewSettings view{640, 400, 1, glslFolder()};
    const Scene scene = parseScene(toml, glslFolder() / "scenes" / "text.toml", overrides, 0.3, places());
    const PreparedScene prepared = prepare(scene, view);
    Renderer renderer(prepared, view, contextFor("auto"),
                      assembleParts(prepared, glslFolder(), ShaderDevice{15, guard}));
    return drawStill(renderer, {0, 0, 640, 400}).picture;
}

// Under open sky, with a ribbon of 100 km that casts no shadow: most of the picture asks for no kernel of its
// own.
const std::string ribbon = R"([camera]
eye = [0, 2, 5]
target = [0, 2.2, 0]
[sky]
gradient = [[0.1, 0.1, 0.1], [0.6, 0.7, 0.8], [0.2, 0.3, 0.7]]
[material.band]
shadow = "none"
[[light]]
kind = "directional"
direction = [-0.4, -1, -0.3]
[[rectangle]]
corner = [-5e4, 0, -3]
edge_u = [1e5, 0, 0]
edge_v = [0, 0.2, 0]
material = "band"
[[sphere]]
centre = [0, 2.9, 0]
radius = 0.5
)";

} // namespace

TEST(ChosenKernels, UnderEveryGuard_AreFedWhatTheyRead)
{
    for (const auto& scene : {ribbon, rising, water, beads + grounds[0].toml})
        for (const char* form : {"trace.form=literal", "trace.form=loop"})
            for (const char* tiles : {"plan.tiles=on", "plan.tiles=off"}) {
                const Picture precise = underGuard(scene, Guard::precise, {form, tiles});
                const Picture unit = underGuard(scene, Guard::unit, {form, tiles});
                EXPECT_LT(compare(unit, precise, 0.01).rmse, mostRmse) << form << ", " << tiles << "\n"
                                                                       << scene;
                EXPECT_NO_THROW(underGuard(scene, Guard::none, {form, tiles}))
                    << form << ", " << tiles << "\n"
                    << scene;
            }
}
