#include "render/exact_arithmetic.h"

#include "gl/limits.h"
#include "gl/texture.h"
#include "render/device_scene.h"
#include "render/probe.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace dioptre
{
namespace
{

constexpr int tableSide = 256; // texels

Picture tableOf(const std::vector<FloatPair>& pairs)
{
    Picture table{tableSide, tableSide, PixelFormat::float32, {}, {}};
    for (const FloatPair& pair : pairs)
        table.floats.insert(table.floats.end(), {pair.a, pair.b, 0.0F, 0.0F});
    return table;
}

// sign * 1.mantissa * 2^exponent
float floatOf(std::uint32_t sign, int exponent, std::uint32_t mantissa)
{
    return std::bit_cast<float>(sign << 31 | static_cast<std::uint32_t>(exponent + 127) << 23 | mantissa);
}

const std::set<std::string> byUnit{"HAS_UNIT"};
const std::set<std::string> byPrecise{"HAS_GPU_SHADER5", "HAS_PRECISE"};

// Compiles glsl/kernel/exact.glsl with features and compares what it gives with the exact results.
class ExactTest
{
public:
    explicit ExactTest(const std::filesystem::path& glslFolder)
        : glslFolder_(glslFolder), pairs_(exactTestPairs()), table_(uploadTable(tableOf(pairs_)))
    {
    }

    ExactTally operator()(const std::set<std::string>& features) const
    {
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, table_.name());
        const Program program = useProbe(glslFolder_, "probe/exact", features);
        glUniform1i(locationOf(program, "u_pairs"), 0);
        glUniform1f(locationOf(program, "u_one"), 1.0F);
        return judgeExact(pairs_, drawProbe(tableSide, tableSide).floats);
    }

private:
    std::filesystem::path glslFolder_;
    std::vector<FloatPair> pairs_;
    Texture table_;
};

Extremes testExtremes(const std::filesystem::path& glslFolder)
{
    const Program program = useProbe(glslFolder, "probe/extremes");
    glUniform1f(locationOf(program, "u_large"), 1.0e20F);
    glUniform1f(locationOf(program, "u_small"), 1.0e-20F);
    glUniform1f(locationOf(program, "u_zero"), 0.0F);
    glUniform1f(locationOf(program, "u_tiny"), 0x1p-70F);
    glUniform1f(locationOf(program, "u_subnormal"), 0x1p-130F);
    const Picture picture = drawProbe(2, 1);
    const auto& values = picture.floats;
    return {values[0], values[1], values[2], values[3], values[4] != 0.0F, values[5] != 0.0F};
}

} // namespace

// Exponents from -38 to 38, those of a pair within 26 of each other: the exact sum then has at most 51 bits,
// and the least error of a product is 2^(-76 - 46), still normal.
std::vector<FloatPair> exactTestPairs()
{
    std::mt19937 random(20240229);
    const auto below = [&random](int count) {
        return static_cast<int>(random() % static_cast<unsigned>(count));
    };
    std::vector<FloatPair> pairs(static_cast<std::size_t>(tableSide) * tableSide);
    for (FloatPair& pair : pairs) {
        const int exponent = below(77) - 38;
        const int other = std::clamp(exponent + below(53) - 26, -38, 38);
        const auto bits = [&random] { return static_cast<std::uint32_t>(random()); };
        const std::uint32_t first = bits(), second = bits();
        pair.a = floatOf(first >> 31, exponent, first & 0x7FFFFFU);
        pair.b = floatOf(second >> 31, other, second & 0x7FFFFFU);
    }
    return pairs;
}

ExactTally judgeExact(std::span<const FloatPair> pairs, std::span<const float> given)
{
    // The exact result as the float nearest to it and the rest, both as the device should give them.
    const auto isRight = [](double exact, float rounded, float error) {
        const auto nearest = static_cast<float>(exact);
        return rounded == nearest && static_cast<double>(error) == exact - static_cast<double>(nearest);
    };
    ExactTally tally;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const double a = static_cast<double>(pairs[i].a), b = static_cast<double>(pairs[i].b);
        tally.twoSum.wrong += isRight(a + b, given[4 * i], given[4 * i + 1]) ? 0 : 1;
        tally.twoProduct.wrong += isRight(a * b, given[4 * i + 2], given[4 * i + 3]) ? 0 : 1;
    }
    tally.twoSum.tested = tally.twoProduct.tested = pairs.size();
    return tally;
}

ExactArithmetic testExactArithmetic(const std::filesystem::path& glslFolder, bool gpuShader5)
{
    const ExactTest test(glslFolder);
    ExactArithmetic arithmetic;
    arithmetic.plain = test({});
    arithmetic.unit = test(byUnit);
    if (gpuShader5) {
        arithmetic.precise = test(byPrecise);
        arithmetic.fma = test({"HAS_GPU_SHADER5", "HAS_PRECISE", "HAS_FMA"}).twoProduct;
    }
    arithmetic.extremes = testExtremes(glslFolder);
    return arithmetic;
}

Guard guardOf(const ExactArithmetic& arithmetic)
{
    if (arithmetic.precise.right())
        return Guard::precise;
    return arithmetic.unit.right() ? Guard::unit : Guard::none;
}

Guard findGuard(const std::filesystem::path& glslFolder)
{
    const ExactTest test(glslFolder);
    if (deviceLimits().gpuShader5 && test(byPrecise).right())
        return Guard::precise;
    return test(byUnit).right() ? Guard::unit : Guard::none;
}

} // namespace dioptre
