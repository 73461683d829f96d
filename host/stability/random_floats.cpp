#include "stability/random_floats.h"

#include <array>
#include <cmath>

namespace dioptre
{

glm::dvec3 unitOf(const glm::dvec3& vector)
{
    return vector / std::sqrt(vector.x * vector.x + vector.y * vector.y + vector.z * vector.z);
}

std::uint64_t seedOf(std::string_view name, std::uint64_t seed)
{
    std::uint64_t hash = 14695981039346656037U ^ seed;
    for (const char letter : name)
        hash = (hash ^ static_cast<unsigned char>(letter)) * 1099511628211U;
    return hash;
}

double RandomFloats::share()
{
    return static_cast<double>(random_() >> 11) * 0x1p-53;
}

double RandomFloats::within(double low, double high)
{
    return low + (high - low) * share();
}

double RandomFloats::sign()
{
    return chance(0.5) ? 1.0 : -1.0;
}

bool RandomFloats::chance(double probability)
{
    return share() < probability;
}

int RandomFloats::below(int count)
{
    return static_cast<int>(share() * count);
}

double RandomFloats::decades(int low, int high)
{
    static constexpr std::array<double, 17> powers{1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1.0,
                                                   1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8};
    const int decade = low + below(high - low);
    return within(1.0, 10.0) * powers[static_cast<std::size_t>(decade + 8)];
}

double RandomFloats::signedDecades(int low, int high)
{
    const double side = sign();
    return side * decades(low, high);
}

glm::dvec3 RandomFloats::inCube(double half)
{
    const double x = within(-half, half); // one after the other: calls in a list of arguments have no order
    const double y = within(-half, half);
    return {x, y, within(-half, half)};
}

glm::dvec3 RandomFloats::direction()
{
    for (;;) {
        const glm::dvec3 point = inCube(1.0);
        const double square = glm::dot(point, point);
        if (square > 0.01 && square <= 1.0)
            return unitOf(point);
    }
}

glm::dvec3 RandomFloats::across(const glm::dvec3& perpendicular)
{
    const glm::dvec3 along = unitOf(perpendicular);
    for (;;) {
        const glm::dvec3 other = direction();
        const glm::dvec3 part = other - glm::dot(other, along) * along;
        if (glm::dot(part, part) > 0.01)
            return unitOf(part);
    }
}

glm::dvec3 RandomFloats::away(double low, double high)
{
    const double length = within(low, high);
    return length * direction();
}

glm::dvec3 RandomFloats::aside(const glm::dvec3& perpendicular, double low, double high)
{
    const double length = within(low, high);
    return length * across(perpendicular);
}

} // namespace dioptre
