#include "stability/scale_sweep.h"

#include "stability/aim.h"
#include "stability/random_floats.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr int lowestHalfDecade = -10, highestHalfDecade = 16;

RayProblem rayAtSphere(RandomFloats& random, double radius_m)
{
    RayProblem problem;
    problem.p[3] = asFloat(radius_m);
    const glm::dvec3 towards = random.direction();
    const glm::dvec3 centre = asFloat((1.0 + radius_m) * towards);
    setPart(problem, 0, centre);
    const double impact = random.within(0.0, 0.9) * radius_m;
    const glm::dvec3 aside = random.across(towards);
    aim(problem, glm::dvec3(0.0), passingPoint(glm::dvec3(0.0), centre, aside, impact));
    return problem;
}

} // namespace

std::vector<ScalePoint> sweepScales(const KernelDevice& device, Variant variant, std::uint64_t seed,
                                    std::size_t rays)
{
    static constexpr CaseRow anySphere{"scale", "a sphere of any size", false, {}};
    std::vector<ScalePoint> points;
    for (int half = lowestHalfDecade; half <= highestHalfDecade; ++half) {
        const double radius_m = std::pow(10.0, 0.5 * half);
        RandomFloats random(seed);
        std::vector<RayProblem> problems;
        for (std::size_t i = 0; i < rays; ++i)
            problems.push_back(rayAtSphere(random, radius_m));
        const auto figures = measureCase(anySphere, problems, answersOf(problems),
                                         runKernels(device, problems, variant, Frame::given));
        if (figures.judgedOver64 > 0)
            points.push_back({radius_m, std::max(figures.relativeT, figures.normal_rad)});
    }
    return points;
}

} // namespace dioptre
