// Paths through glass and between mirrors whose end is known in closed form.
#include "oracle/paths.h"
#include "stability/aim.h"
#include "stability/angle.h"
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

constexpr double glass = 1.5;

// As Material.bending, in air.
dvec4 bendingOf(double index)
{
    return {1.0 / index, index, index * index - 1.0, 1.0 / (index * index) - 1.0};
}

// 1 where a surface on the way was missed.
double missed(Answer answer)
{
    return answer[0].w > 0.5F ? 0.0 : 1.0;
}

// From 2 to 5 radii away, the line at most 0.99 radii from the centre.
void appendBall(RandomFloats& random, std::vector<dvec4>& texels)
{
    const double radius = asFloat(random.within(0.5, 2.0));
    const dvec3 centre = asFloat(random.inCube(1.0));
    const dvec3 origin = asFloat(centre + random.away(2.0 * radius, 5.0 * radius));
    const dvec3 aside = random.across(centre - origin);
    const double impact = 0.99 * radius * std::sqrt(random.share());
    const dvec3 passing = passingPoint(origin, centre, aside, impact);
    texels.emplace_back(origin, 0.0);
    texels.emplace_back(asFloat(unitOf(passing - origin)), 0.0);
    texels.emplace_back(centre, radius);
    texels.push_back(bendingOf(glass));
}

// The ray turns towards the centre, within the plane of both.
ValueErrors ballErrors(Input input, Answer answer)
{
    const dvec3 d = unitOf(dvec3(input[1]));
    const dvec3 toCentre = dvec3(input[2]) - dvec3(input[0]);
    const dvec3 across = toCentre - glm::dot(toCentre, d) * d;
    const double offset = glm::length(across);
    const double turn_rad = ballDeviation_rad(offset / input[2].w, glass);
    const dvec3 inwards = offset > 0.0 ? across / offset : dvec3(0.0);
    const dvec3 leaving = std::cos(turn_rad) * d + std::sin(turn_rad) * inwards;
    const double error_rad = angleBetween_rad(dvec3(vec4(answer[0])), leaving);
    return {missed(answer), missed(answer) > 0.0 ? notJudged : error_rad, notJudged};
}

// A slab of 1e-5 m whose front is met near `target`, from 20 m away.
void appendSlab(RandomFloats& random, std::vector<dvec4>& texels, bool originAtSlab)
{
    const dvec3 normal = random.direction();
    const dvec3 along = random.across(normal);
    const double sine = random.within(0.2, 0.93);
    const dvec3 direction = asFloat(sine * along - std::sqrt(1.0 - sine * sine) * normal);
    const dvec3 way = 20.0 * unitOf(direction);
    const dvec3 front = asFloat((originAtSlab ? dvec3(0.0) : way) + random.aside(normal, 0.0, 1e-3));
    texels.emplace_back(originAtSlab ? asFloat(-way) : dvec3(0.0), 0.0);
    texels.emplace_back(direction, 0.0);
    texels.emplace_back(front, 0.0);
    texels.emplace_back(asFloat(front - 1e-5 * normal), 0.0);
    texels.emplace_back(asFloat(normal), 0.0);
    texels.push_back(bendingOf(glass));
}

// How far a point lies beside the line.
double besides_m(const dvec3& point, const dvec3& onLine, const dvec3& direction)
{
    return glm::length(glm::cross(point - onLine, unitOf(direction)));
}

// Of the slab that the rounded points and normal make.
double trueOffset_m(Input input)
{
    const dvec3 normal = unitOf(dvec3(input[4]));
    const double thickness_m = glm::dot(dvec3(input[2]) - dvec3(input[3]), normal);
    return slabOffset_m(thickness_m, angleBetween_rad(-dvec3(input[1]), normal), glass);
}

ValueErrors slabFromFar(Input input, Answer answer)
{
    const double offset_m = besides_m(dvec3(vec4(answer[0])), dvec3(input[0]), dvec3(input[1]));
    const double error_m = std::abs(offset_m - trueOffset_m(input));
    return {missed(answer), missed(answer) > 0.0 ? notJudged : error_m, notJudged};
}

ValueErrors slabAtOrigin(Input input, Answer answer)
{
    const double offset_m = besides_m(dvec3(vec4(answer[0])), dvec3(vec4(answer[1])), dvec3(input[1]));
    const double truth_m = trueOffset_m(input);
    return {missed(answer), missed(answer) > 0.0 ? notJudged : std::abs(offset_m - truth_m) / truth_m,
            notJudged};
}

// Mirrors 0.5 to 2 m apart, met at 0 to 78 degrees.
void appendFacing(RandomFloats& random, std::vector<dvec4>& texels, const dvec3& unitNormal)
{
    const dvec3 normal = asFloat(unitNormal);
    const double gap_m = random.within(0.5, 2.0);
    const dvec3 first = asFloat(random.inCube(1.0));
    const dvec3 second = asFloat(first + gap_m * normal + random.aside(normal, 0.0, 1.0));
    const double share = random.within(0.1, 0.9);
    const dvec3 origin = asFloat(first + share * gap_m * normal + random.aside(normal, 0.0, 1.0));
    const double cosine = random.sign() * random.within(0.2, 1.0);
    const dvec3 along = random.across(normal);
    texels.emplace_back(origin, 1000.0);
    texels.emplace_back(asFloat(cosine * normal + std::sqrt(1.0 - cosine * cosine) * along), 0.0);
    texels.emplace_back(first, 0.0);
    texels.emplace_back(second, 0.0);
    texels.emplace_back(normal, 0.0);
}

void appendFacingAcrossAxis(RandomFloats& random, std::vector<dvec4>& texels)
{
    dvec3 normal(0.0);
    const int axis = random.below(3);
    normal[axis] = random.sign();
    appendFacing(random, texels, normal);
}

void appendFacingTilted(RandomFloats& random, std::vector<dvec4>& texels)
{
    const dvec3 normal = random.direction();
    appendFacing(random, texels, normal);
}

// Of the path's length, in the frame of the first mirror.
ValueErrors facingErrors(Input input, Answer answer)
{
    const dvec3 z = unitOf(dvec3(input[4]));
    const dvec3 x = unitOf(glm::cross(z, std::abs(z.x) < 0.5 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0)));
    const dvec3 y = glm::cross(z, x);
    const auto inFrame = [&](const dvec3& v) {
        return dvec3(glm::dot(v, x), glm::dot(v, y), glm::dot(v, z));
    };
    const dvec3 first(input[2]);
    const double gap_m = glm::dot(dvec3(input[3]) - first, z);
    const MirrorStop truth = facingMirrors(gap_m, inFrame(dvec3(input[0]) - first), inFrame(dvec3(input[1])),
                                           static_cast<int>(input[0].w));
    const double off_m = glm::length(inFrame(dvec3(vec4(answer[0])) - first) - truth.point);
    return {missed(answer), missed(answer) > 0.0 ? notJudged : off_m / truth.length_m, notJudged};
}

// A ray that glances within 1e-3 rad along the inside of a sphere about the origin.
void appendGallery(RandomFloats& random, std::vector<dvec4>& texels, const dvec3& outward,
                   const dvec3& tangent, int bounces)
{
    constexpr double glancing = 1e-3;
    const double radius = asFloat(random.within(0.5, 2.0));
    texels.emplace_back(asFloat(radius * outward), bounces);
    texels.emplace_back(asFloat(std::sqrt(1.0 - glancing * glancing) * tangent - glancing * outward), 0.0);
    texels.emplace_back(0.0, 0.0, 0.0, radius);
}

// From the end of one axis along another.
template <int bounces>
void appendGalleryFromAxis(RandomFloats& random, std::vector<dvec4>& texels)
{
    dvec3 outward(0.0);
    dvec3 tangent(0.0);
    const int axis = random.below(3);
    const int next = (axis + 1 + random.below(2)) % 3;
    outward[axis] = random.sign();
    tangent[next] = random.sign();
    appendGallery(random, texels, outward, tangent, bounces);
}

void appendGalleryTilted(RandomFloats& random, std::vector<dvec4>& texels)
{
    const dvec3 outward = random.direction();
    const dvec3 tangent = random.across(outward);
    appendGallery(random, texels, outward, tangent, 100);
}

// Of the radius. The rounded start is taken for the point of the sphere below it.
ValueErrors galleryErrors(Input input, Answer answer)
{
    const dvec3 outward = unitOf(dvec3(input[0]));
    const dvec3 direction = unitOf(dvec3(input[1]));
    const double sine = -glm::dot(direction, outward);
    const dvec3 tangent = unitOf(direction + sine * outward);
    const double radius = input[2].w;
    const glm::dvec2 place = whisperingGallery(radius, std::asin(sine), static_cast<int>(input[0].w));
    const dvec3 truth = place.x * outward + place.y * tangent;
    const double off = glm::length(dvec3(vec4(answer[0])) - truth) / radius;
    return {missed(answer), missed(answer) > 0.0 ? notJudged : off, notJudged};
}

ValueRow pathRow(std::string_view name, std::string_view about, const char* feature, std::size_t texels,
                 int parts, ValueGate gate, void (*append)(RandomFloats&, std::vector<dvec4>&),
                 ValueErrors (*measure)(Input, Answer), std::size_t count)
{
    gate.error = 1;
    return {name,
            about,
            false,
            "stability/paths",
            {feature, "HAS_ROUND_SHAPE", "HAS_SPHERE", "HAS_FLAT"},
            texels,
            parts,
            {{"missed/1e6", 0.0, Of::perMillion}, gate},
            append,
            measure,
            count};
}

} // namespace

std::vector<ValueRow> pathValues()
{
    return {
        pathRow("B01", "glass ball, n = 1.5", "HAS_BALL", 4, 1, {"rad", 1e-5}, appendBall, ballErrors,
                100000),
        pathRow(
            "B02", "glass slab of 1e-5 m at 20 m", "HAS_SLAB", 6, 2, {"m", 4 * 0x1p-24 * 20.0},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendSlab(r, t, false); }, slabFromFar, 100000),
        pathRow(
            "B03", "glass slab of 1e-5 m at the scene's origin", "HAS_SLAB", 6, 2, {"rel", 1e-3},
            [](RandomFloats& r, std::vector<dvec4>& t) { appendSlab(r, t, true); }, slabAtOrigin, 100000),
        asControl(pathRow("W01", "facing mirrors across an axis, bounce 1000", "HAS_FACING", 5, 1,
                          {"rel", 2e-5}, appendFacingAcrossAxis, facingErrors, 4096)),
        // The length of a tilted normal is 1 but for rounding, up to sqrt(3) 2^-25, which turns the ray at
        // each bounce.
        asControl(pathRow("W02", "facing mirrors at any tilt, bounce 1000", "HAS_FACING", 5, 1, {"rel", 1e-4},
                          appendFacingTilted, facingErrors, 4096)),
        pathRow("W03", "whispering gallery, 1e-3 rad, bounce 10", "HAS_GALLERY", 3, 1, {"rel", 5e-7},
                appendGalleryFromAxis<10>, galleryErrors, 100000),
        pathRow("W04", "whispering gallery, bounce 100", "HAS_GALLERY", 3, 1, {"rel", 5e-5},
                appendGalleryFromAxis<100>, galleryErrors, 20000),
        // Rounding place and direction to floats once a bounce, all else exact, makes 7e-4 of this and at
        // worst 2.6e-3 in 4096: of so long a path only the typical error can be asked for.
        pathRow("W05", "whispering gallery, bounce 1000", "HAS_GALLERY", 3, 1,
                {"rms", 2e-3, Of::rootMeanSquare}, appendGalleryFromAxis<1000>, galleryErrors, 4096),
        // Every bounce rounds the glancing angle by some 2^-24, which the next ones carry on.
        pathRow("W06", "whispering gallery at any tilt, bounce 100", "HAS_GALLERY", 3, 1, {"rel", 5e-4},
                appendGalleryTilted, galleryErrors, 20000),
    };
}

} // namespace dioptre
