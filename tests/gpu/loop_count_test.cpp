// The loop iterations that the host counts for a sample, against the driver that ends loops: rays bounce for
// ever within a mirror, so that every ray of the budget is traced unless the driver cuts them off.
#include "render/samples.h"
#include "scene/load.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

struct Case {
    std::string name;
    int balls = 1;
    int lights = 0;
    std::string trace;   // lines of [trace]
    std::string surface; // lines of the material
};

void PrintTo(const Case& hall, std::ostream* stream)
{
    *stream << hall.name;
}

// Concentric balls around the eye in a hollow mirror, which takes so little of a ray that none fades away.
std::string sceneOf(const Case& hall)
{
    std::string text =
        "[camera]\neye = [0,0,0]\ntarget = [0.3,0.1,-1]\n[trace]\ncut_off = 0\n" + hall.trace +
        "\n[material.wall]\nmirror = 0.999\nshadow = \"none\"\n[material.m]\ncolour = [1,1,1]\n" +
        hall.surface + "\n";
    for (int i = 0; i < hall.lights; ++i) // of both kinds that have a loop of their own
        text += i % 2 == 0 ? "[[light]]\nkind = \"point\"\nposition = [0.5,0,0]\n"
                           : "[[light]]\nkind = \"directional\"\ndirection = [0,-1,0]\n";
    for (int i = 0; i < hall.balls; ++i)
        text += "[[sphere]]\ncentre = [0,0,0]\nradius = " + std::to_string(2 + i) + "\nmaterial = \"m\"\n";
    return text + "[[sphere]]\ncentre = [0,0,0]\nradius = 20\nmaterial = \"wall\"\n";
}

long iterationsAt(const std::string& scene, int budget)
{
    const auto prepared = prepare(parseScene(scene, "hall.toml", {"trace.budget=" + std::to_string(budget)}),
                                  {8, 8, 1, glslFolder()});
    return loopIterations(prepared.plan, prepared.packed);
}

// The greatest budget of which a sample is not refused; the loader takes 4096.
int greatestBudget(const std::string& scene)
{
    int least = 1, most = 4096;
    while (least < most) {
        const int middle = (least + most + 1) / 2;
        if (iterationsAt(scene, middle) <= softwareLoopCap)
            least = middle;
        else
            most = middle - 1;
    }
    return least;
}

class LoopCount : public testing::TestWithParam<Case>
{
};

} // namespace

// A queue or a stack has a place for each ray, which compilers take long over: balls and lights make rays
// dear.
INSTANTIATE_TEST_SUITE_P(
    Halls, LoopCount,
    testing::Values(
        Case{"OneBall", 1, 0, "form = \"loop\"", "mirror = 0.999"},
        Case{"FiveBalls", 5, 0, "form = \"loop\"", "mirror = 0.999"},
        Case{"Lights", 3, 4, "form = \"loop\"", "mirror = 0.999"},
        Case{"LightsWithoutShadows", 3, 4, "form = \"loop\"", "mirror = 0.999\nshadow = \"none\""},
        Case{"LiteralLights", 1, 30, "form = \"literal\"", "mirror = 0.999"},
        Case{"LiteralOneLight", 1, 1, "form = \"literal\"", "mirror = 0.999"},
        Case{"PoolAlways", 3, 5, "form = \"literal\"\n[plan]\npool = \"always\"", "mirror = 0.999"},
        Case{"Queue", 20, 4, "form = \"loop\"\norder = \"breadth-first\"", "mirror = 0.999"},
        Case{"Stack", 20, 4, "form = \"loop\"\norder = \"depth-first\"",
             "mirror = 0.001\ntransmit = 1\nior = 1.0001"},
        Case{"Pool", 3, 2, "form = \"loop\"", "mirror = 0.001\ntransmit = 1\nior = 1.0001"},
        Case{"PoolAndLiterals", 3, 5, "form = \"literal\"", "mirror = 0.001\ntransmit = 1\nior = 1.0001"}),
    [](const auto& info) { return info.param.name; });

TEST_P(LoopCount, AtTheGreatestBudgetThatIsNotRefused_EveryRayIsTraced)
{
    const std::string scene = sceneOf(GetParam());
    const int budget = greatestBudget(scene);
    const long iterations = iterationsAt(scene, budget);
    const auto still = renderSceneText(scene, {8, 8, 1, {"trace.budget=" + std::to_string(budget)}, "auto"});
    EXPECT_EQ(still.raysPerSample, budget) << iterations << " iterations";
}
