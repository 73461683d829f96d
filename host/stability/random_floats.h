// Random inputs of the suite: the same on every platform, and numbers that a float holds exactly.
#pragma once

#include "base/as_float.h"

#include <glm/glm.hpp>

#include <cstdint>
#include <random>
#include <string_view>

namespace dioptre
{

// The vector over its length, without any approximate instruction.
glm::dvec3 unitOf(const glm::dvec3& vector);

// Of a row of the suite, whose inputs do not depend on which others run: FNV-1a of its name.
std::uint64_t seedOf(std::string_view name, std::uint64_t seed);

// Only sums, products, quotients and square roots, which IEEE 754 rounds alike everywhere; results are
// doubles. Two draws in one expression would come in any order: draw one by one.
class RandomFloats
{
public:
    explicit RandomFloats(std::uint64_t seed) : random_(seed) {}

    double share(); // 0 <= x < 1
    double within(double low, double high);
    double sign(); // -1 or 1
    bool chance(double probability);
    int below(int count); // 0 .. count - 1

    // Between 10^low and 10^high, each decade as likely, uniform within it; -8 <= low < high <= 8.
    double decades(int low, int high);
    double signedDecades(int low, int high);

    glm::dvec3 inCube(double half);
    glm::dvec3 direction();                             // unit, uniform on the sphere
    glm::dvec3 across(const glm::dvec3& perpendicular); // unit, at right angles to it
    // The last two times a length of low..high.
    glm::dvec3 away(double low, double high);
    glm::dvec3 aside(const glm::dvec3& perpendicular, double low, double high);

private:
    std::mt19937_64 random_;
};

} // namespace dioptre
