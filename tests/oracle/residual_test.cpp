// Over random problems of many scales: the answer lies on the surface to quad's last digits, and no surface
// lies before it.
#include "oracle/crossing.h"
#include "problems.h"
#include "randoms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace dioptre
{
namespace
{

// Any kind, 1e-6 to 1e8 in size, up to 1e4 sizes away or up to 1e-2 sizes near its reference point.
RayProblem randomProblem(Randoms& random, int primitive)
{
    const double size = std::pow(10.0, random.within(-6.0, 8.0));
    const double away = size * std::pow(10.0, random.within(-2.0, 4.0));
    RayProblem problem;
    problem.primitive = primitive;
    setPart(problem.p, 0, random.inCube(10.0 * size));
    setPart(problem.p, 3, random.inCube(size));
    setPart(problem.p, 6, random.inCube(size));
    if (primitive == shapeSphere)
        problem.p[3] = size * random.within(0.1, 1.0);
    else if (primitive <= shapeCappedCylinder || primitive == shapeDisk)
        problem.p[6] = size * random.within(0.1, 1.0);
    if (primitive == shapeTriangle)
        for (const std::size_t corner : {3, 6})
            setPart(problem.p, corner, partOf(problem.p, corner) + partOf(problem.p, 0));
    problem.origin = partOf(problem.p, 0) + away * glm::normalize(random.inCube(1.0));
    const glm::dvec3 aim = partOf(problem.p, 0) + random.inCube(0.7 * size);
    problem.direction = std::pow(10.0, random.within(-3.0, 3.0)) / away * (aim - problem.origin);
    return problem;
}

// The nearest of the surface's implicit functions to 0, at a point relative to the reference point, over
// `scale`. Cylinders by the cross product, flat shapes by the triple product.
Quad residual(const QuadShape& shape, const QuadVec& point, Quad scale)
{
    const Quad square = scale * scale;
    switch (shape.primitive) {
    case shapeSphere:
        return magnitude(dot(point, point) - shape.radius * shape.radius) / square;
    case shapeOpenCylinder:
    case shapeCappedCylinder: {
        const QuadVec across = cross(point, shape.first);
        const Quad aa = dot(shape.first, shape.first);
        const Quad side = magnitude(dot(across, across) / aa - shape.radius * shape.radius) / square;
        if (shape.primitive == shapeOpenCylinder)
            return side;
        const Quad height = dot(point, shape.first);
        const Quad cap =
            magnitude(height) < magnitude(height - aa) ? magnitude(height) : magnitude(height - aa);
        const Quad flat = cap / (sqrtq(aa) * scale);
        return side < flat ? side : flat;
    }
    case shapePlane:
    case shapeDisk:
        return magnitude(dot(point, shape.first)) / (sqrtq(dot(shape.first, shape.first)) * scale);
    default:
        const QuadVec normal = cross(shape.first, shape.second);
        return magnitude(dot(point, normal)) / (sqrtq(dot(normal, normal)) * scale);
    }
}

// Whether a point is within a solid; for an open cylinder, within the endless one.
bool isInside(const RayProblem& problem, const glm::dvec3& point)
{
    const glm::dvec3 offset = point - partOf(problem.p, 0);
    if (problem.primitive == shapeSphere)
        return glm::length(offset) < problem.p[3];
    const glm::dvec3 axis = partOf(problem.p, 3);
    const double height = glm::dot(offset, axis) / glm::dot(axis, axis);
    const bool withinWall = glm::length(offset - height * axis) < problem.p[6];
    return withinWall && (problem.primitive == shapeOpenCylinder || (height > 0.0 && height < 1.0));
}

bool besideWall(const RayProblem& problem, const glm::dvec3& point)
{
    const glm::dvec3 axis = partOf(problem.p, 3);
    const double height = glm::dot(point - partOf(problem.p, 0), axis) / glm::dot(axis, axis);
    return height > 0.0 && height < 1.0;
}

// Whether the ray passes into or out of the shape between its start and `end`, told from points along it.
bool scanFindsSurface(const RayProblem& problem, double end)
{
    constexpr int points = 4000;
    bool inside = isInside(problem, problem.origin);
    bool beside = false;
    for (int i = 1; i < points; ++i) {
        const glm::dvec3 point = problem.origin + (end * i / points) * problem.direction;
        const bool was = std::exchange(inside, isInside(problem, point));
        const bool wasBeside = std::exchange(beside, besideWall(problem, point));
        if (inside != was && (problem.primitive != shapeOpenCylinder || (beside && wasBeside)))
            return true;
    }
    return false;
}

} // namespace

TEST(Oracle_Residual, AtEveryAnswer_IsBelowQuadsRoundingOfTheWay)
{
    Randoms random(11);
    for (int kind = shapeSphere; kind <= shapeTriangle; ++kind) {
        int hits = 0;
        for (int i = 0; i < 3000; ++i) {
            const RayProblem problem = randomProblem(random, kind);
            const QuadShape shape = quadShape(kind, problem.p);
            const QuadHit hit =
                firstHit(shape, {quadFrom(problem.origin), quadFrom(problem.direction)}, 0, false);
            if (!hit.hit)
                continue;
            ++hits;
            const double way = static_cast<double>(hit.t) * glm::length(problem.direction);
            const double scale = extentOf(problem) + way;
            EXPECT_LT(static_cast<double>(residual(shape, hit.offset, scale)), 1e-30)
                << "kind " << kind << ", problem " << i;
        }
        EXPECT_GT(hits, 200) << "kind " << kind;
    }
}

TEST(Oracle_FirstHit, NothingLiesBeforeIt_AndNothingWhereItMisses)
{
    Randoms random(12);
    int hits = 0;
    int misses = 0;
    for (const int kind : {shapeSphere, shapeOpenCylinder, shapeCappedCylinder})
        for (int i = 0; i < 1000; ++i) {
            const RayProblem problem = randomProblem(random, kind);
            const RayAnswer answer = solve(problem);
            (answer.hit ? hits : misses) += 1;
            const double past = 2.0 * extentOf(problem) / glm::length(problem.direction);
            const double end = answer.hit ? answer.t * (1.0 - 1e-9) : past;
            EXPECT_FALSE(scanFindsSurface(problem, end)) << "kind " << kind << ", problem " << i;
        }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(misses, 500);
}

// The scan itself is no judge that always says yes.
TEST(Oracle_FirstHit, TheScan_FindsTheHitItself)
{
    Randoms random(12);
    int found = 0;
    int hits = 0;
    for (int i = 0; i < 1000; ++i) {
        const RayProblem problem = randomProblem(random, shapeSphere);
        const RayAnswer answer = solve(problem);
        hits += answer.hit ? 1 : 0;
        const double chord = 2.0 * problem.p[3] * answer.cosIncidence / glm::length(problem.direction);
        found += answer.hit && scanFindsSurface(problem, answer.t + 0.5 * chord) ? 1 : 0;
    }
    EXPECT_GT(found, hits * 8 / 10);
}

TEST(Oracle_Answer, ItsParts_AgreeWithOneAnother)
{
    Randoms random(13);
    for (int kind = shapeSphere; kind <= shapeTriangle; ++kind)
        for (int i = 0; i < 500; ++i) {
            const RayProblem problem = randomProblem(random, kind);
            const RayAnswer answer = solve(problem);
            if (!answer.hit)
                continue;
            EXPECT_GT(answer.t, 0.0);
            EXPECT_NEAR(glm::length(answer.normal), 1.0, 4e-16);
            const glm::dvec3 along = problem.origin + answer.t * problem.direction;
            EXPECT_LE(glm::length(answer.point - along),
                      1e-15 * (glm::length(along) + 2.0 * extentOf(problem)));
            const double cosine = glm::dot(answer.normal, glm::normalize(problem.direction));
            EXPECT_NEAR(answer.cosIncidence, std::abs(cosine), 1e-15);
        }
}

} // namespace dioptre
