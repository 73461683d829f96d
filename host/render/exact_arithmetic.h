// Whether this device's arithmetic can carry compensated kernels: a self-test of error-free transformations,
// judged by the host in double precision, which is exact for the error of a sum or product of floats.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace dioptre
{

struct FloatPair {
    float a = 0.0F;
    float b = 0.0F;
};

// Results that were compared with the exact ones; nothing tested where the device lacks what it takes.
struct Tally {
    std::size_t tested = 0;
    std::size_t wrong = 0;

    bool right() const
    {
        return tested > 0 && wrong == 0;
    }
};

// Of glsl/kernel/exact.glsl, compiled in one way.
struct ExactTally {
    Tally twoSum;     // Knuth's
    Tally twoProduct; // Dekker's, or by fma() where that is what was compiled

    bool right() const
    {
        return twoSum.right() && twoProduct.right();
    }
};

// What comes of numbers at the edges of float.
struct Extremes {
    float normalizeLarge = 0.0F;   // normalize((1e20, 0, 0)).x; 1 where it is right
    float normalizeSmall = 0.0F;   // normalize((1e-20, 0, 0)).x; 1 where it is right
    float atanOfZeros = 0.0F;      // atan(0, 0); GLSL leaves it undefined
    float powOfZeros = 0.0F;       // pow(0, 0); GLSL leaves it undefined
    bool subnormalResults = false; // a result below the smallest normal float is kept, not made zero
    bool subnormalOperands = false;
};

struct ExactArithmetic {
    ExactTally plain;   // as written
    ExactTally precise; // every intermediate declared `precise`: GLSL lets it end at a function's call
    ExactTally unit;    // bits flipped by a uniform that is known to be 0 to the host alone
    Tally fma;          // two-product by fma(); wrong where it rounds twice
    Extremes extremes;
};

// On the current context; `gpuShader5` as in DeviceLimits.
ExactArithmetic testExactArithmetic(const std::filesystem::path& glslFolder, bool gpuShader5);

// What guards compensated kernels against the compiler. Plain code is never trusted: another kernel may be
// regrouped where this one was not.
enum class Guard { precise, unit, none };
Guard guardOf(const ExactArithmetic& arithmetic); // none: compensated kernels are off

// The same from as few tests as that takes, on the current context.
Guard findGuard(const std::filesystem::path& glslFolder);

// Pairs of both signs over 23 decades, from a fixed seed; sums and products and their errors are normal
// floats.
std::vector<FloatPair> exactTestPairs();

// Compares what a device gave for each pair, (sum, its error, product, its error), with the exact results.
ExactTally judgeExact(std::span<const FloatPair> pairs, std::span<const float> given);

} // namespace dioptre
