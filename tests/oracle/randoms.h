// Random numbers that are the same on every platform.
#pragma once

#include <glm/glm.hpp>

#include <random>

namespace dioptre
{

class Randoms
{
public:
    explicit Randoms(unsigned seed) : random_(seed) {}

    double within(double low, double high)
    {
        return low + (high - low) * static_cast<double>(random_()) / 4294967296.0;
    }

    glm::dvec3 inCube(double half)
    {
        const double x =
            within(-half, half); // one after the other: calls in a list of arguments have no order
        const double y = within(-half, half);
        return {x, y, within(-half, half)};
    }

private:
    std::mt19937 random_;
};

} // namespace dioptre
