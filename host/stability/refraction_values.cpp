// Snell's law near the critical angle, and Fresnel's shares.
#include "oracle/optics.h"
#include "stability/random_floats.h"
#include "stability/value_rows.h"

#include <algorithm>
#include <cmath>

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

// From within glass, within `reach` of the critical angle, of which the sine is the index.
void appendNearCritical(RandomFloats& random, std::vector<dvec4>& texels, double reach_rad)
{
    const dvec3 normal = asFloat(random.direction());
    const double index = 1.0 / random.within(1.45, 1.6);
    const double off = random.within(-reach_rad, reach_rad); // as a sine
    const double sine = index * std::sqrt(1.0 - off * off) + std::sqrt(1.0 - index * index) * off;
    const dvec3 along = random.across(normal);
    const dvec3 direction = asFloat(sine * along - std::sqrt(1.0 - sine * sine) * unitOf(normal));
    texels.emplace_back(direction, index);
    texels.emplace_back(normal, index * index - 1.0);
}

// 1 where light is let through that is all reflected, or the other way round.
ValueErrors flipOfTotalReflection(Input input, Answer answer)
{
    const bool total = !snellDirection(dvec3(input[0]), dvec3(input[1]), input[0].w);
    return {(answer[0].x > 0.5F) == total ? 0.0 : 1.0, notJudged, notJudged};
}

// Cosines over the whole range, half of them small.
void appendInterface(RandomFloats& random, std::vector<dvec4>& texels, double index)
{
    const double cosine = asFloat(random.chance(0.5) ? random.decades(-4, 0) / 10.0 : 1.0 - random.share());
    texels.emplace_back(cosine, index, index * index - 1.0, 0.0);
}

ValueErrors relativeReflectance(Input input, Answer answer)
{
    const double truth = fresnelShares(input[0].x, input[0].y).reflected;
    return {std::abs(static_cast<double>(answer[0].x) - truth) / truth, notJudged, notJudged};
}

double offOne(Answer answer)
{
    return std::abs(static_cast<double>(answer[0].x) + static_cast<double>(answer[0].y) - 1.0);
}

// The reflectance's error in units of 1e-6 and of what two units in the last place of the cosine change.
ValueErrors reflectanceOfBound(Input input, Answer answer)
{
    const double c = input[0].x;
    const double index = input[0].y;
    const double above = fresnelShares(std::min(c * (1.0 + 0x1p-22), 1.0), index).reflected;
    const double below = fresnelShares(c * (1.0 - 0x1p-22), index).reflected;
    const double off = std::abs(static_cast<double>(answer[0].x) - fresnelShares(c, index).reflected);
    return {off / (1e-6 + std::abs(above - below)), offOne(answer), notJudged};
}

ValueErrors sumOfShares(Input, Answer answer)
{
    return {offOne(answer), notJudged, notJudged};
}

// Within glass as often as from outside, and where both media are one.
void appendAnyInterface(RandomFloats& random, std::vector<dvec4>& texels)
{
    const double denser = random.chance(0.5) ? random.within(1.0, 1.5) : random.decades(0, 2);
    const bool leaving = denser <= 1.5 && random.chance(0.5);
    appendInterface(random, texels, random.chance(0.01) ? 1.0 : (leaving ? 1.0 / denser : denser));
}

void appendRarerInterface(RandomFloats& random, std::vector<dvec4>& texels)
{
    appendInterface(random, texels, 1.0 / random.decades(0, 2));
}

ValueRow criticalRow(std::string_view name, std::string_view about, double flipsPerMillion,
                     void (*append)(RandomFloats&, std::vector<dvec4>&), std::size_t count)
{
    return {name,
            about,
            false,
            "stability/optics",
            {"HAS_CRITICAL"},
            2,
            1,
            {{"flips/1e6", flipsPerMillion, Of::perMillion}},
            append,
            flipOfTotalReflection,
            count};
}

ValueRow fresnelRow(std::string_view name, std::string_view about, std::vector<ValueGate> gates,
                    void (*append)(RandomFloats&, std::vector<dvec4>&), ValueErrors (*measure)(Input, Answer))
{
    return {name,   about,   false, "stability/optics", {"HAS_FRESNEL"}, 1, 1, std::move(gates),
            append, measure, 50000};
}

} // namespace

std::vector<ValueRow> refractionValues()
{
    return {
        // Some 240 a million: as many inputs as it takes for the share to stand out of its own chance.
        asControl(criticalRow(
            "N01", "refraction, glass, critical angle +- 1e-4 rad", 300.0,
            [](RandomFloats& r, std::vector<dvec4>& t) { appendNearCritical(r, t, 1e-4); }, 1000000)),
        asControl(criticalRow(
            "N02", "refraction, glass, critical angle +- 1e-6 rad", 30000.0,
            [](RandomFloats& r, std::vector<dvec4>& t) { appendNearCritical(r, t, 1e-6); }, 100000)),
        fresnelRow(
            "F01", "Fresnel, n = 1 + 1e-6", {{"rel", 1e-6}},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendInterface(r, t, 1.0 + 1e-6); },
            relativeReflectance),
        asControl(fresnelRow(
            "F02", "Fresnel, n = 1.5", {{"rel", 1e-6}},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendInterface(r, t, 1.5); }, relativeReflectance)),
        asControl(fresnelRow(
            "F03", "Fresnel, n = 100", {{"rel", 1e-6}},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendInterface(r, t, 100.0); },
            relativeReflectance)),
        fresnelRow("F04", "Fresnel, n = 1/1.5 to 100",
                   {{"of bound", 1.0}, {"R + T - 1", 1e-6, Of::largest, 1}}, appendAnyInterface,
                   reflectanceOfBound),
        asControl(fresnelRow("F05", "Fresnel, n = 1/100 to 1", {{"R + T - 1", 1e-4}}, appendRarerInterface,
                             sumOfShares)),
    };
}

} // namespace dioptre
