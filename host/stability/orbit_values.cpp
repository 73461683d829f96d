// Chaotic mirrors: every bounce multiplies an error, whatever the formula. Gaspard and Rice, "Scattering from
// a classically chaotic repellor", 1989.
#include "oracle/orbit.h"
#include "stability/random_floats.h"
#include "stability/value_rows.h"

#include <cmath>
#include <optional>

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

struct Scene {
    int spheres = 3;
    double distance = 6.0; // of centres, in radii
    int bounces = 4;       // that the itinerary is judged through
    int early = 2;         // the bounce that growth is measured from
};

struct Bounce {
    int sphere = -1; // -1: the ray escapes
    dvec3 point{0.0}, direction{0.0};
};

std::vector<MirrorSphere> spheresOf(const Scene& scene)
{
    std::vector<MirrorSphere> spheres = mirrorSpheres(scene.spheres, scene.distance);
    for (MirrorSphere& sphere : spheres)
        sphere.centre = asFloat(sphere.centre);
    return spheres;
}

// Good for finding starts; the truth is the oracle's.
Bounce nextBounce(std::span<const MirrorSphere> spheres, const Bounce& from)
{
    Bounce next;
    double nearest = 0.0;
    for (int i = 0; i < static_cast<int>(spheres.size()); ++i) {
        const MirrorSphere& sphere = spheres[static_cast<std::size_t>(i)];
        const dvec3 f = from.point - sphere.centre;
        const double b = -glm::dot(f, from.direction);
        const dvec3 foot = f + b * from.direction;
        const double reach = sphere.radius * sphere.radius - glm::dot(foot, foot);
        const double t = b - std::sqrt(std::max(reach, 0.0));
        if (i == from.sphere || reach < 0.0 || t <= 0.0 || (next.sphere >= 0 && t > nearest))
            continue;
        nearest = t;
        const dvec3 normal = unitOf(f + t * from.direction);
        next.sphere = i;
        next.point = sphere.centre + sphere.radius * normal;
        next.direction = unitOf(from.direction - 2.0 * glm::dot(from.direction, normal) * normal);
    }
    return next;
}

int bouncesOf(std::span<const MirrorSphere> spheres, const dvec3& origin, const dvec3& direction, int most)
{
    Bounce at{-1, origin, unitOf(direction)};
    for (int i = 0; i < most; ++i) {
        at = nextBounce(spheres, at);
        if (at.sphere < 0)
            return i;
    }
    return most;
}

// A direction that lasts for so many bounces: the way through one more is looked for in an ever narrower cone
// about one that lasts for fewer.
std::optional<dvec3> lastingDirection(RandomFloats& random, std::span<const MirrorSphere> spheres,
                                      const dvec3& origin, int bounces)
{
    dvec3 best = unitOf(random.inCube(1.0) - origin);
    double width = 1.0;
    int reached = bouncesOf(spheres, origin, asFloat(best), bounces);
    for (int attempt = 0; attempt < 2000 && reached < bounces; ++attempt) {
        const dvec3 near = asFloat(unitOf(best + width * random.inCube(1.0)));
        const int lasts = bouncesOf(spheres, origin, near, bounces);
        if (lasts > reached) {
            best = near;
            reached = lasts;
        } else if (lasts < reached) {
            width = std::max(0.9 * width, 1e-6); // too wide to keep what was reached
        } else if (random.chance(0.5)) {
            best = near; // as good: wander
            width = std::min(1.2 * width, 1.0);
        }
    }
    return reached >= bounces ? std::optional(asFloat(best)) : std::nullopt;
}

void appendOrbit(RandomFloats& random, std::vector<dvec4>& texels, const Scene& scene)
{
    const std::vector<MirrorSphere> spheres = spheresOf(scene);
    for (;;) {
        const dvec3 origin = asFloat(random.away(2.0 * scene.distance, 3.0 * scene.distance));
        const auto direction = lastingDirection(random, spheres, origin, scene.bounces);
        if (!direction)
            continue;
        texels.emplace_back(origin, scene.bounces);
        texels.emplace_back(*direction, scene.early);
        for (std::size_t i = 0; i < 4; ++i)
            texels.push_back(i < spheres.size() ? dvec4(spheres[i].centre, spheres[i].radius) : dvec4(0.0));
        return;
    }
}

// 1 for a wrong itinerary; log10 of how the device's error grows from the early bounce to the last, and of
// how any small one does in quad precision.
ValueErrors orbitErrors(Input input, Answer answer)
{
    std::vector<MirrorSphere> spheres;
    for (std::size_t i = 2; i < input.size(); ++i)
        if (input[i].w > 0.0)
            spheres.push_back({dvec3(input[i]), input[i].w});
    const auto bounces = static_cast<int>(input[0].w);
    const auto early = static_cast<int>(input[1].w);
    const dvec3 origin(input[0]);
    const dvec3 direction(input[1]);
    const std::vector<OrbitStop> orbit = mirrorOrbit(spheres, origin, direction, bounces);
    if (static_cast<int>(orbit.size()) < bounces)
        return {notJudged, notJudged, notJudged};
    double itinerary = 0.0;
    for (const OrbitStop& stop : orbit)
        itinerary = 4.0 * itinerary + stop.sphere;
    if (static_cast<double>(answer[0].w) != itinerary)
        return {1.0, notJudged, notJudged};
    const auto off = [&](std::size_t part, int bounce) {
        return glm::length(dvec3(vec4(answer[part])) - orbit[static_cast<std::size_t>(bounce - 1)].point);
    };
    const double growth = std::log10(std::max(off(0, bounces), 1e-12) / std::max(off(1, early), 1e-12));
    const double exact = orbitGrowth_log10(spheres, origin, direction, bounces) * (bounces - 1) -
                         orbitGrowth_log10(spheres, origin, direction, early) * (early - 1);
    return {0.0, growth, exact};
}

ValueRow orbitRow(std::string_view name, std::string_view about,
                  void (*append)(RandomFloats&, std::vector<dvec4>&))
{
    return {name,
            about,
            false,
            "stability/paths",
            {"HAS_ORBIT", "HAS_ROUND_SHAPE", "HAS_SPHERE"},
            6,
            2,
            {{"wrong/1e6", 1e4, Of::perMillion}, {"slope off", 0.2, Of::slope, 1}},
            append,
            orbitErrors,
            2000};
}

} // namespace

std::vector<ValueRow> orbitValues()
{
    return {
        orbitRow("X01", "3 mirror spheres, D = 6 R, bounce 4",
                 [](RandomFloats& r, std::vector<dvec4>& t) {
                     appendOrbit(r, t, {3, 6.0, 4, 2});
                 }),
        orbitRow("X02", "3 mirror spheres, D = 2.5 R, bounce 10",
                 [](RandomFloats& r, std::vector<dvec4>& t) {
                     appendOrbit(r, t, {3, 2.5, 10, 3});
                 }),
        orbitRow("X03", "4 mirror spheres, D = 2.1 R, bounce 12",
                 [](RandomFloats& r, std::vector<dvec4>& t) {
                     appendOrbit(r, t, {4, 2.1, 12, 3});
                 }),
    };
}

} // namespace dioptre
