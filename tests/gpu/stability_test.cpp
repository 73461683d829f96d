// The kernels on this device against the quad-precision oracle, every row of the suite by a few of its rays.
#include "gl/limits.h"
#include "render/probe.h"
#include "stability/kernel_run.h"
#include "support/process.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>
#include <unistd.h>

using namespace dioptre;
using dioptre::test::contextFor;
using dioptre::test::glslFolder;

namespace
{

// The full counts take a minute.
std::size_t raysOf(const CaseRow& row)
{
    const char* full = std::getenv("DIOPTRE_FULL");
    return full != nullptr && std::string(full) == "yes" ? row.rays : 2000;
}

KernelDevice deviceOf(const std::string& backend)
{
    contextFor(backend);
    return {glslFolder(), guardOf(testExactArithmetic(glslFolder(), deviceLimits().gpuShader5))};
}

class Stability : public testing::TestWithParam<std::string>
{
protected:
    CaseFigures figures(std::optional<Variant> variant, const std::string& backend = "auto") const
    {
        return measureCase(row, problems, truth,
                           runKernels(deviceOf(backend), problems, variant, Frame::given));
    }

    const CaseRow& row = caseRow(GetParam());
    std::vector<RayProblem> problems = problemsOf(row.name, 1, raysOf(row));
    std::vector<RayAnswer> truth = answersOf(problems);
};

std::vector<std::string> caseNames()
{
    std::vector<std::string> names;
    for (const CaseRow& row : caseRows())
        names.emplace_back(row.name);
    return names;
}

RayProblem sphere(const glm::dvec3& centre, double radius, const glm::dvec3& origin,
                  const glm::dvec3& direction)
{
    RayProblem problem;
    problem.p = {centre.x, centre.y, centre.z, radius};
    problem.origin = origin;
    problem.direction = direction;
    return problem;
}

} // namespace

INSTANTIATE_TEST_SUITE_P(Cases, Stability, testing::ValuesIn(caseNames()),
                         [](const auto& info) { return info.param; });

TEST_P(Stability, OurKernels_HoldTheGate_WhichTheTextbooksBreaks)
{
    const Verdict ours = judgeCase(row, figures(std::nullopt));
    EXPECT_TRUE(ours.pass) << ours.reason;
    if (!row.control) {
        EXPECT_FALSE(judgeCase(row, figures(Variant::textbook)).pass)
            << "the textbook's kernel passes: the row shows nothing";
    }
}

// Seen from each ray's own origin, as a user's rays are.
TEST_P(Stability, RebasedRays_HoldTheGateToo)
{
    const auto answers = runKernels(deviceOf("auto"), problems, std::nullopt, Frame::ofRay);
    const Verdict verdict = judgeCase(row, measureCase(row, problems, truth, answers));
    EXPECT_TRUE(verdict.pass) << verdict.reason;
}

TEST(StabilityDevice, ASphereFarAway_PassesUnderOsMesaToo)
{
    const CaseRow& row = caseRow("S02");
    const auto problems = problemsOf(row.name, 2, 2000);
    const auto answers = runKernels(deviceOf("osmesa"), problems, std::nullopt, Frame::given);
    const Verdict verdict = judgeCase(row, measureCase(row, problems, answersOf(problems), answers));
    EXPECT_TRUE(verdict.pass) << verdict.reason;
}

// Inputs that no float holds: rounding them first would move what is met by millimetres.
TEST(StabilityDevice, NumbersThatAreNoFloats_AreTakenInFull)
{
    const double third = 1.0e6 + 1.0 / 3.0;
    const std::vector<RayProblem> problems{
        sphere({third, 0.0, 0.0}, 1.0e-3, {third, 0.0, 2.0}, {0.0, 0.0, -1.0}),
        sphere({third, 0.7e-3, 0.0}, 1.0e-3, {third, 0.0, 2.0}, {1.0e-4 / 3.0, 1.0e-4 / 7.0, -1.0}),
        sphere({0.1, 0.2, -1.0e7}, 100.0 / 3.0, {0.3, 0.4, 0.0}, {2.0e-6 / 3.0, 1.0e-6 / 3.0, -1.0})};
    const auto truth = answersOf(problems);
    const auto answers = runKernels(deviceOf("auto"), problems, std::nullopt, Frame::ofRay);
    for (std::size_t i = 0; i < problems.size(); ++i) {
        ASSERT_TRUE(truth[i].hit) << i;
        ASSERT_TRUE(answers[i].hit) << i;
        EXPECT_NEAR(answers[i].t, truth[i].t, 3.0e-7 * truth[i].t) << i;
        EXPECT_LT(glm::length(glm::cross(answers[i].normal, truth[i].normal)), 1.0e-6) << i;
    }
}

// The square of such a length is no float.
TEST(StabilityDevice, LengthsBeyondAFloatsSquare_AreScaledByPowersOfTwo)
{
    for (const double scale : {0x1p-100, 0x1p100}) {
        const std::vector<RayProblem> problems{
            sphere(scale * glm::dvec3(0.5, 0.0, -4.0), scale, glm::dvec3(0.0), glm::dvec3(0.0, 0.0, -1.0))};
        const auto answer = runKernels(deviceOf("auto"), problems, std::nullopt, Frame::ofRay).front();
        ASSERT_TRUE(answer.hit) << scale;
        EXPECT_NEAR(answer.t / scale, 4.0 - std::sqrt(0.75), 1.0e-6);
    }
}

TEST(StabilityShaders, GlslangValidator_AcceptsThemAsGlsl330)
{
    const std::vector<std::set<std::string>> kinds{{"HAS_SPHERE"},
                                                   {"HAS_CYLINDER", "HAS_OPEN_CYLINDER"},
                                                   {"HAS_CYLINDER", "HAS_CAPPED_CYLINDER"},
                                                   {"HAS_FLAT", "HAS_PLANE"},
                                                   {"HAS_FLAT", "HAS_DISK"},
                                                   {"HAS_FLAT", "HAS_RECTANGLE"},
                                                   {"HAS_FLAT", "HAS_TRIANGLE"}};
    const auto file =
        std::filesystem::temp_directory_path() / ("dioptre-shapes-" + std::to_string(getpid()) + ".frag");
    for (const auto& kind : kinds)
        for (const char* variant : {"HAS_TEXTBOOK", "HAS_ROBUST", "HAS_COMPENSATED", "HAS_CURVATURE"}) {
            std::set<std::string> features = kind;
            features.insert({variant, "HAS_UNIT"});
            if (kind.contains("HAS_FLAT") && features.contains("HAS_CURVATURE"))
                continue; // nothing bends
            std::ofstream(file) << flatten(probeText(glslFolder(), "stability/shapes", features));
            const auto outcome = dioptre::test::run("glslangValidator -C '" + file.string() + "'");
            EXPECT_EQ(outcome.code, 0) << *kind.rbegin() << " " << variant << "\n" << outcome.out;
        }
    std::filesystem::remove(file);
}

// Sums and products without loss are worth what the compiler leaves of them.
TEST(StabilityDevice, WithoutItsGuard_TheCompensatedKernelIsNoBetter)
{
    KernelDevice device = deviceOf("auto");
    ASSERT_NE(device.guard, Guard::none);
    const CaseRow& row = caseRow("S07");
    const auto problems = problemsOf(row.name, 1, 2000);
    const auto truth = answersOf(problems);
    device.guard = Guard::none;
    const auto answers = runKernels(device, problems, Variant::compensated, Frame::given);
    const Verdict verdict = judgeCase(row, measureCase(row, problems, truth, answers));
    EXPECT_FALSE(verdict.pass) << "plain code is exact here: nothing shows that the guard is needed";
}
