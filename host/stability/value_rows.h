// The suite's rows beside intersections: formulas of optics and paths of many bounces, each held against quad
// precision.
#pragma once

#include <glm/glm.hpp>

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

class RandomFloats;

// Up to three errors of one answer, as its row means them; `notJudged` where the answer stands for none.
using ValueErrors = std::array<double, 3>;
inline constexpr double notJudged = std::numeric_limits<double>::quiet_NaN();

// The largest that a figure may be.
struct ValueGate {
    enum class Of {
        largest,        // of errors[error]
        rootMeanSquare, // of errors[error]
        perMillion,     // of all inputs, the sum of errors[error], which are 0 or 1
        slope           // |sum of errors[error] / sum of errors[error + 1] - 1|
    };
    std::string_view what; // "rel", "rad": what the figure is called
    double most = 0.0;
    Of of = Of::largest;
    std::size_t error = 0;
};

struct ValueRow {
    std::string_view name;
    std::string_view about;            // one phrase
    bool control = false;              // passed by the textbook's formula too
    std::string_view shader;           // "stability/optics"
    std::vector<const char*> features; // besides HAS_TEXTBOOK
    std::size_t texels = 1;            // of one input, as the shader reads them
    int parts = 1;                     // vec4 of one answer
    std::vector<ValueGate> gates;
    // Appends one input's texels. All numbers are floats, but for ratios of indices and what follows from
    // them, which the host makes in double precision and the device gets rounded.
    void (*append)(RandomFloats& random, std::vector<glm::dvec4>& texels) = nullptr;
    // Of an answer whose numbers are finite.
    ValueErrors (*measure)(std::span<const glm::dvec4> input, std::span<const glm::vec4> answer) = nullptr;
    std::size_t count = 100000; // inputs of a full run
};

// The row, marked as one that the textbook's formula passes too.
ValueRow asControl(ValueRow row);

// In the order of the table.
std::span<const ValueRow> valueRows();

// Fails with ExitCode::usage on a name that is none.
const ValueRow& valueRow(std::string_view name);

// Topics of the table, in order.
std::vector<ValueRow> refractionValues(); // Snell's law and Fresnel's
std::vector<ValueRow> shadingValues();    // lobes, lights and maps
std::vector<ValueRow> pathValues();       // through glass, between mirrors
std::vector<ValueRow> orbitValues();      // among mirror spheres

// The texels of the first `count` inputs, one after the other: the same for the same seed.
std::vector<glm::dvec4> inputsOf(const ValueRow& row, std::uint64_t seed, std::size_t count);

// "rel <= 1e-06, R + T - 1 <= 1e-06".
std::string gateText(const ValueRow& row);

} // namespace dioptre
