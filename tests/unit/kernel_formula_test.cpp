// Kernels of glsl/ whose truth is a short computation, in double precision.
#include "base/picture.h"

#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace dioptre::formula
{

#include "kernel/glsl_as_cpp.h"

#define float double
#define HAS_DOUBLE
// In this order.
// clang-format off
#include "../glsl/shared/constants.glsl"
#include "../glsl/kernel/blur.glsl"
#include "../glsl/kernel/microfacet.glsl"
// clang-format on
#undef HAS_DOUBLE
#undef float

namespace
{

// A ray in the plane z = 0.
struct Line {
    vec2 origin, direction;
};

vec2 across(const vec2& direction)
{
    return {-direction.y, direction.x};
}

double span(const vec2& a, const vec2& b)
{
    return a.x * b.x + a.y * b.y;
}

// What becomes of a line at the unit circle: mirrored, or refracted by n_i / n_t = eta. `inner`: it starts
// within.
Line passed(const Line& line, bool inner, bool mirrored, double eta)
{
    const double b = span(line.origin, line.direction);
    const double reach = std::sqrt(b * b - span(line.origin, line.origin) + 1.0);
    const double t = -b + (inner ? reach : -reach);
    const vec2 place = line.origin + t * line.direction;
    const vec2 normal = inner ? -place : place;
    const double cosine = -span(line.direction, normal);
    if (mirrored)
        return {place, line.direction + 2.0 * cosine * normal};
    const double through = std::sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
    return {place, eta * line.direction + (eta * cosine - through) * normal};
}

// The blur of a line against another that differs little.
Blur between(const Line& line, const Line& other)
{
    const vec2 aside = across(line.direction);
    return blurOf(span(other.origin - line.origin, aside), span(other.direction, aside));
}

// Relative to the larger of both.
void expectAlike(const Blur& found, const Blur& truth, double flip)
{
    EXPECT_NEAR(found.offset, flip * truth.offset, 1e-4 * std::abs(truth.offset));
    EXPECT_NEAR(found.angle, flip * truth.angle,
                1e-4 * std::abs(truth.angle) + 1e-4 * std::abs(truth.offset));
}

void checkPassage(bool inner, bool mirrored, double eta)
{
    for (const double height : {0.1, 0.4, 0.7}) // of the line over the centre
        for (const auto& [offset, angle] : {std::pair{1e-7, 0.0}, {0.0, 1e-7}, {1e-7, -3e-7}}) {
            const Line line{inner ? vec2(0.2, height) : vec2(-3.0, height), vec2(1.0, 0.0)};
            const vec2 turned = vec2(std::cos(angle), std::sin(angle));
            const Line other{line.origin + offset * across(line.direction), turned};
            const Line after = passed(line, inner, mirrored, eta);
            const vec2 normal = inner ? -after.origin : after.origin;
            const double cosine = -span(line.direction, normal);
            const double through = std::abs(span(after.direction, normal));
            const double t = span(after.origin - line.origin, line.direction);
            const Blur before = blurOf(offset, angle);
            const double there = blurAcross(before, t, 0.0);
            const double curvature = inner ? -1.0 : 1.0;
            const Blur found = mirrored ? blurMirrored(before, there, cosine, curvature)
                                        : blurRefracted(before, there, cosine, through, eta, curvature);
            const Blur truth = between(after, passed(other, inner, mirrored, eta));
            // A mirror turns left and right about.
            SCOPED_TRACE(testing::Message()
                         << "height " << height << ", offset " << offset << ", angle " << angle);
            expectAlike(found, truth, mirrored ? -1.0 : 1.0);
        }
}

} // namespace

TEST(Blur, AtAMirror_FollowsTwoRaysThatDifferLittle)
{
    checkPassage(false, true, 1.0);
    checkPassage(true, true, 1.0);
}

TEST(Blur, AtAnInterface_FollowsTwoRaysThatDifferLittle)
{
    for (const double eta : {1.0 / 1.5, 1.0, 1.3}) {
        SCOPED_TRACE(eta);
        checkPassage(false, false, eta);
        checkPassage(true, false, eta);
    }
}

TEST(Blur, OfRounding_AddsWhateverTheSign)
{
    EXPECT_EQ(blurAcross(blurOf(1.0, 0.0), 2.0, 0.5), 1.5);
    EXPECT_EQ(blurAcross(blurOf(-1.0, 0.0), 2.0, 0.5), -1.5);
    EXPECT_EQ(blurAcross(blurOf(0.0, 0.0), 2.0, 0.5), 0.5);
}

namespace
{

vec3 towards(double cosine, double turn)
{
    const double sine = std::sqrt(1.0 - cosine * cosine);
    return {sine * std::cos(turn), sine * std::sin(turn), cosine};
}

// What a white rough mirror sends to the viewer under light of 1 from everywhere: the mean over the
// hemisphere, whose solid angle goes by the cosine. Light comes by the half vectors' slopes, where narrow
// lobes are wide.
double albedo(double alpha, double cosine)
{
    const vec3 viewer = towards(cosine, 0.0);
    const vec3 normal(0.0, 0.0, 1.0);
    constexpr int steps = 600;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
        for (int k = 0; k < steps; ++k) {
            // The density's own distribution: tan^2 = alpha^2 u / (1 - u).
            const double u = (i + 0.5) / steps;
            const double squared = alpha * alpha * u / (1.0 - u);
            const vec3 half = towards(1.0 / std::sqrt(1.0 + squared), 2.0 * PI * (k + 0.5) / steps);
            const vec3 light = 2.0 * dot(viewer, half) * half - viewer;
            if (light.z <= 0.0 || dot(viewer, half) <= 0.0)
                continue;
            const double chance = microfacetDensity(normal, half, alpha) * half.z / (4.0 * dot(viewer, half));
            sum += microfacetLobe(normal, light, viewer, alpha, vec3(1.0)).x / PI / chance;
        }
    return sum / (steps * steps);
}

} // namespace

TEST(Microfacets, NeverSendOutMoreThanTheyGet_AndAllOfItWhereTheyAreSmooth)
{
    for (const double cosine : {1.0, 0.6, 0.1}) {
        for (const double alpha : {1e-4, 1e-2, 0.1, 0.5, 1.0})
            EXPECT_LT(albedo(alpha, cosine), 1.0 + 1e-6) << alpha << ", " << cosine;
        // Light that hits two facets is lost to this model: the less the smoother.
        EXPECT_GT(albedo(1e-4, cosine), 0.9999) << cosine;
        EXPECT_GT(albedo(0.1, cosine), 0.85) << cosine;
        EXPECT_GT(albedo(1.0, cosine), 0.3) << cosine;
    }
}

TEST(Microfacets, ServeLightAndViewerAlike)
{
    const vec3 normal(0.0, 0.0, 1.0);
    for (const double alpha : {1e-4, 0.2, 1.0}) {
        const vec3 a = towards(0.8, 0.3), b = towards(0.35, 2.9);
        const double there = microfacetLobe(normal, a, b, alpha, vec3(0.3)).x / a.z;
        const double back = microfacetLobe(normal, b, a, alpha, vec3(0.3)).x / b.z;
        EXPECT_NEAR(there, back, 1e-9 * there) << alpha;
    }
}

TEST(Microfacets, ReflectAllAtGrazing_AndTheirShareHeadOn)
{
    // The peak of a lobe over that of a white one is its reflectance.
    const vec3 normal(0.0, 0.0, 1.0);
    const auto shareAt = [&](double cosine) {
        const vec3 light = towards(cosine, 0.0), viewer = towards(cosine, PI);
        return microfacetLobe(normal, light, viewer, 0.1, vec3(0.04)).x /
               microfacetLobe(normal, light, viewer, 0.1, vec3(1.0)).x;
    };
    EXPECT_NEAR(shareAt(1.0), 0.04, 1e-12);
    EXPECT_GT(shareAt(0.01), 0.95);
    EXPECT_EQ(microfacetLobe(normal, towards(-0.1, 0.0), towards(0.5, 1.0), 0.1, vec3(1.0)), vec3(0.0))
        << "from behind";
}

} // namespace dioptre::formula
