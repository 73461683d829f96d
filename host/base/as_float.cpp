#include "base/as_float.h"

namespace dioptre
{

double asFloat(double value)
{
    // Through memory: where g++ 12.2 vectorises two such conversions it drops both, and the double stays what
    // it was.
    const volatile auto nearest = static_cast<float>(value);
    return static_cast<double>(nearest);
}

glm::dvec3 asFloat(const glm::dvec3& value)
{
    return {asFloat(value.x), asFloat(value.y), asFloat(value.z)};
}

} // namespace dioptre
