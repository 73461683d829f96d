// The formulations of a kernel, and which a shape needs.
#pragma once

#include "oracle/problem.h"

#include <array>
#include <optional>
#include <string_view>

namespace dioptre
{

enum class Variant {
    textbook,    // as books print it; no picture is made with it
    robust,      // what a scene of ordinary numbers runs
    compensated, // with error-free transformations
    curvature    // sphere and cylinder from a surface point and 1 / radius
};

struct VariantName {
    std::string_view name;
    Variant variant;
};
inline constexpr std::array variantNames{
    VariantName{"textbook", Variant::textbook}, VariantName{"robust", Variant::robust},
    VariantName{"compensated", Variant::compensated}, VariantName{"curvature", Variant::curvature}};
std::string_view nameOf(Variant variant);

// Whether the kind of shape has a kernel of that variant.
bool isFor(Variant variant, int primitive);

// The strictest: curvature for a round shape whose radius is over 1e4 times the distance from the point that
// numbers are seen from to its surface, and to the ray's origin; else compensated.
Variant strictestFor(const RayProblem& problem, const glm::dvec3& frameOrigin);

} // namespace dioptre
