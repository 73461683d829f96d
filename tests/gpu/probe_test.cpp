// What glsl/probe/ measures on this machine's software driver, whose faults are known.
#include "base/file.h"
#include "base/write_file.h"
#include "gl/limits.h"
#include "render/device_scene.h"
#include "render/exact_arithmetic.h"
#include "render/loop_canary.h"
#include "render/probe.h"
#include "render/samples.h"
#include "support/process.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <numbers>
#include <unistd.h>

using namespace dioptre;
using dioptre::test::contextFor;
using dioptre::test::glslFolder;

namespace
{

class Probe : public testing::TestWithParam<std::string>
{
protected:
    void SetUp() override
    {
        if (contextFor(GetParam()).renderer.find("llvmpipe") == std::string::npos)
            GTEST_SKIP() << "the figures are llvmpipe's";
    }
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Backends, Probe, testing::Values("auto", "osmesa"),
                         [](const auto& info) { return info.param; });

TEST_P(Probe, Limits_AreThoseThatOpenGl33Demands)
{
    const DeviceLimits limits = deviceLimits();
    EXPECT_GE(limits.textureSide_px, 1024);
    EXPECT_GE(limits.pictureSide_px, 1024);
    EXPECT_LE(limits.pictureSide_px, limits.viewportHeight_px);
    EXPECT_GE(limits.arrayLayers, 256);
    EXPECT_GE(limits.uniformBlock_bytes, 16384);
    EXPECT_GE(limits.fragmentUniformBlocks, 12);
    EXPECT_GE(limits.fragmentUniformComponents, 1024);
    EXPECT_GE(limits.fragmentTextureUnits, 16);
    EXPECT_TRUE(limits.drawsIntoFloat);
}

TEST_P(Probe, Loops_EndAfterTheCapThatDrawsArePlannedFor)
{
    const LoopCanary canary = measureLoops(glslFolder());
    EXPECT_TRUE(canary.faithful);
    ASSERT_TRUE(canary.capped());
    EXPECT_EQ(canary.ran, softwareLoopCap);
    EXPECT_TRUE(loopsSuffice(canary, true));
}

TEST_P(Probe, LoopCap_IsSharedByLoopsAndNeighbours)
{
    const LoopCanary canary = measureLoops(glslFolder());
    EXPECT_EQ(canary.ranOfTwo[0], canary.askedOfTwo);
    EXPECT_TRUE(canary.sharedByLoops());
    EXPECT_EQ(canary.ranOfTwo[0] + 1 + canary.ranOfTwo[1], softwareLoopCap)
        << "the look that ends the first loop counts as well";
    EXPECT_TRUE(canary.sharedByNeighbours());
    EXPECT_LT(canary.askedOfNeighbours, softwareLoopCap);
}

TEST_P(Probe, TwoSum_IsWrongAsWrittenAndRightUnderEachGuard)
{
    const DeviceLimits limits = deviceLimits();
    ASSERT_TRUE(limits.gpuShader5);
    const ExactArithmetic arithmetic = testExactArithmetic(glslFolder(), limits.gpuShader5);
    EXPECT_GT(arithmetic.plain.twoSum.wrong, 32768U);
    EXPECT_EQ(arithmetic.plain.twoProduct.wrong, 0U);
    EXPECT_TRUE(arithmetic.precise.right()) << arithmetic.precise.twoSum.wrong;
    EXPECT_TRUE(arithmetic.unit.right()) << arithmetic.unit.twoSum.wrong;
    EXPECT_EQ(arithmetic.fma.tested, 65536U);
    EXPECT_EQ(guardOf(arithmetic), Guard::precise);
}

TEST_P(Probe, WithoutGpuShader5_TheUniformGuards)
{
    const ExactArithmetic arithmetic = testExactArithmetic(glslFolder(), false);
    EXPECT_EQ(arithmetic.precise.twoSum.tested, 0U);
    EXPECT_EQ(arithmetic.fma.tested, 0U);
    EXPECT_EQ(guardOf(arithmetic), Guard::unit);
}

// Mesa regroups how a constant is split into halves, and nothing else, unless each step is held.
TEST_P(Probe, AGuardThatLeavesStepsOut_IsFoundOut)
{
    const auto glsl =
        std::filesystem::path(testing::TempDir()) / ("half_guarded_" + std::to_string(getpid()));
    std::filesystem::copy(glslFolder(), glsl, std::filesystem::copy_options::recursive);
    std::string text = readFile(glsl / "kernel" / "exact.glsl");
    for (const auto& [guarded, bare] : {std::pair{"HELD(SPLITTER * a)", "SPLITTER * a"},
                                        {"HELD(scaled - HELD(scaled - a))", "scaled - HELD(scaled - a)"}}) {
        const auto at = text.find(guarded);
        ASSERT_NE(at, std::string::npos) << guarded;
        text.replace(at, std::string(guarded).size(), bare);
    }
    writeFile(glsl / "kernel" / "exact.glsl", text);
    const ExactArithmetic arithmetic = testExactArithmetic(glsl, deviceLimits().gpuShader5);
    std::filesystem::remove_all(glsl);
    EXPECT_TRUE(arithmetic.unit.twoSum.right());
    EXPECT_GT(arithmetic.unit.twoProduct.wrong, 32768U);
    EXPECT_TRUE(arithmetic.precise.right());
}

// A square that overflows gives 0, one that vanishes infinity.
TEST_P(Probe, Normalize_FailsOutsideTheRangeOfSquares)
{
    const Extremes extremes = testExactArithmetic(glslFolder(), false).extremes;
    EXPECT_EQ(extremes.normalizeLarge, 0.0F);
    EXPECT_TRUE(std::isinf(extremes.normalizeSmall));
    EXPECT_FALSE(extremes.subnormalResults);
    EXPECT_FALSE(extremes.subnormalOperands);
}

TEST_P(Probe, Draws_AddUpInFloat)
{
    const FloatSums sums = probeFloatSums(glslFolder());
    EXPECT_TRUE(sums.right) << sums.worst_ulp;
}

// A thousandth of a texel of a sky 8192 wide is 7.7e-7 rad. Measured 4.8e-7, of which the rounding of angles
// near a half turn is 1.2e-7; llvmpipe's own is off by 3.4e-6.
TEST_P(Probe, ArctangentByPolynomial_IsWithinAThousandthOfATexelInEveryDirection)
{
    constexpr int reach = 128;
    constexpr int side = 2 * reach + 1;
    const Program program = useProbe(glslFolder(), "probe/arctangent", {"HAS_ARCTANGENT_POLYNOMIAL"});
    double worst = 0.0, worstOfDriver = 0.0;
    for (const float unit : {1.0F, -1.0F}) { // zeros of both signs
        glUniform1f(locationOf(program, "u_unit"), unit);
        const Picture picture = drawProbe(side, side);
        for (int y = -reach; y <= reach; ++y) {
            for (int x = -reach; x <= reach; ++x) {
                if (x == 0 && y == 0)
                    continue;
                const double exact = std::atan2(static_cast<double>(unit) * y, static_cast<double>(unit) * x);
                const float* pixel =
                    &picture.floats[static_cast<std::size_t>(4 * (side * (y + reach) + x + reach))];
                // Either end of a full turn is right.
                const auto error = [&](float angle) {
                    return std::abs(
                        std::remainder(static_cast<double>(angle) - exact, 2.0 * std::numbers::pi));
                };
                worst = std::max(worst, error(pixel[0]));
                worstOfDriver = std::max(worstOfDriver, error(pixel[1]));
                if (y != 0) {
                    EXPECT_EQ(pixel[2], 0.5F) << "u of a pole";
                    EXPECT_EQ(pixel[3], unit * static_cast<float>(y) > 0.0F ? 1.0F : 0.0F) << "v of a pole";
                }
            }
        }
    }
    std::cout << "polynomial " << worst << " rad, the driver's own " << worstOfDriver << " rad\n";
    EXPECT_LT(worst, 7.7e-7);
}

TEST(ProbeShaders, GlslangValidator_AcceptsThemAsGlsl330)
{
    const std::vector<std::pair<std::string, std::set<std::string>>> variants{
        {"add", {}},
        {"loops", {}},
        {"loops", {"HAS_TURNS"}},
        {"extremes", {}},
        {"arctangent", {}},
        {"arctangent", {"HAS_ARCTANGENT_POLYNOMIAL"}},
        {"exact", {}},
        {"exact", {"HAS_UNIT"}},
        {"exact", {"HAS_GPU_SHADER5", "HAS_PRECISE"}},
        {"exact", {"HAS_GPU_SHADER5", "HAS_PRECISE", "HAS_FMA"}}};
    const auto file =
        std::filesystem::temp_directory_path() / ("dioptre-probe-" + std::to_string(getpid()) + ".frag");
    for (const auto& [name, features] : variants) {
        SourceText text = probeText(glslFolder(), "probe/" + name, features);
        if (features.contains("HAS_GPU_SHADER5")) // of which glslang knows a part below GLSL 4.00
            text.front().text = "#version 400 core";
        std::ofstream(file) << flatten(text);
        const auto outcome = dioptre::test::run("glslangValidator -C '" + file.string() + "'");
        EXPECT_EQ(outcome.code, 0) << name << "\n" << outcome.out;
    }
    std::filesystem::remove(file);
}

TEST_P(Probe, Clocks_BothTellATime)
{
    const Clocks clocks = probeClocks(glslFolder());
    EXPECT_GT(clocks.finish_ms, 0.0);
    EXPECT_GT(clocks.timerQuery_ms, 0.0) << "the query was not read";
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
}
