// Highlights, spots, the fall of light with distance, and latitude-longitude maps.
#include "oracle/shading.h"
#include "stability/angle.h"
#include "stability/random_floats.h"
#include "stability/value_rows.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre
{
namespace
{

using glm::dvec3;
using glm::dvec4;
using glm::vec4;
using Input = std::span<const dvec4>;
using Answer = std::span<const vec4>;
using Of = ValueGate::Of;

double relative(float answer, double truth)
{
    return std::abs(static_cast<double>(answer) - truth) / truth;
}

// Two unit vectors, their angle's tangent as given.
void appendPair(RandomFloats& random, std::vector<dvec4>& texels, double tangent, double w)
{
    const dvec3 first = random.direction();
    const dvec3 second = unitOf(first + tangent * random.across(first));
    texels.emplace_back(asFloat(first), w);
    texels.emplace_back(asFloat(second), 0.0);
}

// Out to ten times the distribution's width.
void appendRough(RandomFloats& random, std::vector<dvec4>& texels, double alpha)
{
    const double widths = random.chance(0.5) ? random.within(0.0, 10.0) : random.decades(-3, 0);
    appendPair(random, texels, alpha * widths, asFloat(alpha));
}

ValueErrors relativeDensity(Input input, Answer answer)
{
    const double truth = microfacetDensity(dvec3(input[0]), dvec3(input[1]), input[0].w);
    return {relative(answer[0].x, truth), notJudged, notJudged};
}

// Out to where the lobe is exp(-20) of its peak.
void appendLobe(RandomFloats& random, std::vector<dvec4>& texels)
{
    constexpr double exponent = 1e5;
    appendPair(random, texels, std::sqrt(random.within(0.0, 40.0) / exponent), exponent);
}

ValueErrors relativeLobe(Input input, Answer answer)
{
    const double truth = cosineLobe(dvec3(input[0]), dvec3(input[1]), input[0].w);
    return {relative(answer[0].x, truth), notJudged, notJudged};
}

// 1e-3 to 2e-2 rad wide; half of the places within 1e-6 to 1e-2 of the rim.
void appendCone(RandomFloats& random, std::vector<dvec4>& texels)
{
    const dvec3 axis = asFloat(random.direction());
    const dvec3 light = asFloat(random.inCube(1.0));
    const double cutoff_rad = random.within(1e-3, 2e-2);
    const double nearRim = 1.0 + random.signedDecades(-7, -3);
    const double angle_rad = cutoff_rad * (random.chance(0.5) ? nearRim : 1.2 * random.share());
    const double distance_m = random.within(1.0, 10.0);
    const dvec3 aside = random.across(axis);
    const double half = std::sin(0.5 * cutoff_rad);
    texels.emplace_back(light, asFloat(random.within(0.0, 1000.0)));
    texels.emplace_back(axis, 4.0 * half * half);
    texels.emplace_back(asFloat(light + distance_m * (axis + angle_rad * aside)), std::cos(cutoff_rad));
}

// What rounding the unit vector to the light may turn it by is no flip.
ValueErrors coneErrors(Input input, Answer answer)
{
    constexpr double margin_rad = 8 * 0x1p-24;
    const dvec3 axis(input[1]);
    const dvec3 fromLight = dvec3(input[2]) - dvec3(input[0]);
    const double cutoff_rad = 2.0 * std::asin(0.5 * std::sqrt(input[1].w));
    const SpotCone truth = spotCone(axis, fromLight, cutoff_rad, input[0].w);
    const bool inside = answer[0].x > 0.0F;
    const bool clear = std::abs(angleBetween_rad(axis, fromLight) - cutoff_rad) > margin_rad;
    const bool both = inside && truth.inside;
    return {clear && inside != truth.inside ? 1.0 : 0.0,
            both ? relative(answer[0].x, truth.strength) : notJudged, notJudged};
}

// Places from the light's own to three times its least distance away.
void appendNearLight(RandomFloats& random, std::vector<dvec4>& texels)
{
    const double nearest_m = asFloat(random.decades(-3, 0));
    const dvec3 light = random.chance(0.5) ? dvec3(0.0) : asFloat(random.inCube(1.0));
    const double reach = random.chance(0.5) ? 3.0 * random.share() : random.decades(-8, 0);
    const double distance_m = random.chance(0.02) ? 0.0 : nearest_m * reach;
    const dvec3 place = asFloat(light + distance_m * random.direction());
    const int kind = random.below(3);
    dvec3 coefficients(1.0, 0.0, 0.0);
    if (kind == 1)
        coefficients = {0.0, 0.0, asFloat(1.0 / (nearest_m * nearest_m))};
    if (kind == 2) {
        coefficients.x = asFloat(random.share());
        coefficients.y = asFloat(random.decades(-3, 3));
        coefficients.z = asFloat(random.decades(-3, 6));
    }
    texels.emplace_back(light, nearest_m);
    texels.emplace_back(coefficients, 0.0);
    texels.emplace_back(place, 0.0);
}

// Nearer than 1e-15 m any direction will do.
ValueErrors nearLightErrors(Input input, Answer answer)
{
    const dvec3 offset = dvec3(input[0]) - dvec3(input[2]);
    const double distance_m = glm::length(offset);
    const double truth = attenuationAt(dvec3(input[1]), distance_m, input[0].w);
    const dvec3 towards(answer[0].y, answer[0].z, answer[0].w);
    return {relative(answer[0].x, truth), distance_m > 1e-15 ? angleBetween_rad(towards, offset) : notJudged,
            notJudged};
}

// Everywhere, about the poles and on both sides of the seam.
void appendDirection(RandomFloats& random, std::vector<dvec4>& texels)
{
    dvec3 direction = random.away(0.1, 10.0);
    const int region = random.below(4);
    if (region == 2) {
        const double ring = random.decades(-7, -1);
        const dvec3 aside = random.across({0.0, 1.0, 0.0});
        direction = ring * aside + dvec3(0.0, random.sign(), 0.0);
    }
    if (region == 3) {
        const double x = random.signedDecades(-8, -1);
        direction = {x, random.within(-1.0, 1.0), -random.within(0.1, 1.0)};
    }
    texels.emplace_back(asFloat(direction), 0.0);
}

// Either end of a full turn is right.
ValueErrors mapError_rad(Input input, Answer answer)
{
    const glm::dvec2 truth = latLongPlace(dvec3(input[0]));
    const double turns = std::remainder(static_cast<double>(answer[0].x) - truth.x, 1.0);
    const double halfTurns = static_cast<double>(answer[0].y) - truth.y;
    return {std::numbers::pi * std::max(2.0 * std::abs(turns), std::abs(halfTurns)), notJudged, notJudged};
}

ValueRow shadingRow(std::string_view name, std::string_view about, std::vector<const char*> features,
                    std::size_t texels, std::vector<ValueGate> gates,
                    void (*append)(RandomFloats&, std::vector<dvec4>&), ValueErrors (*measure)(Input, Answer))
{
    return {name,   about,  false, "stability/optics", std::move(features), texels, 1, std::move(gates),
            append, measure};
}

} // namespace

std::vector<ValueRow> shadingValues()
{
    return {
        shadingRow(
            "G01", "GGX, alpha = 1e-4", {"HAS_MICROFACET"}, 2, {{"rel", 2e-6}},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendRough(r, t, 1e-4); }, relativeDensity),
        shadingRow(
            "G02", "GGX, alpha = 1e-2", {"HAS_MICROFACET"}, 2, {{"rel", 2e-6}},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendRough(r, t, 1e-2); }, relativeDensity),
        shadingRow("L01", "lobe, exponent 1e5", {"HAS_LOBE"}, 2, {{"rel", 1e-5}}, appendLobe, relativeLobe),
        shadingRow(
            "L02", "spot, cone of 1e-3 to 2e-2 rad", {"HAS_CONE", "HAS_PLACED_LIGHT", "HAS_SPOT_LIGHT"}, 3,
            {{"flips/1e6", 0.0, Of::perMillion}, {"rel", 1e-5, Of::largest, 1}}, appendCone, coneErrors),
        shadingRow("L03", "light, within and near its least distance", {"HAS_DISTANCE", "HAS_PLACED_LIGHT"},
                   3, {{"rel", 1e-6}, {"rad", 1e-6, Of::largest, 1}}, appendNearLight, nearLightErrors),
        // A thousandth of a texel of a sky of 8192.
        shadingRow("M01", "latitude-longitude map", {"HAS_DIRECTION", "HAS_ARCTANGENT_POLYNOMIAL"}, 1,
                   {{"rad", 7.7e-7}}, appendDirection, mapError_rad),
    };
}

} // namespace dioptre
