#include "metric/flip_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace dioptre
{
namespace
{

using std::numbers::pi;

// The eye's contrast sensitivity in space: a sqrt(pi / b) exp(-pi^2 x^2 / b), x in degrees (table 1).
struct Sensitivity {
    double a;
    double b;
};
constexpr Sensitivity achromatic[] = {{1.0, 0.0047}}, redGreen[] = {{1.0, 0.0053}},
                      blueYellow[] = {{34.1, 0.04}, {13.5, 0.025}};
constexpr double widest = 0.04; // of all b

double sigma_px(double b, double pixelsPerDegree)
{
    return std::sqrt(b / (2.0 * pi * pi)) * pixelsPerDegree;
}

std::size_t radiusFor(double sigma_px)
{
    return static_cast<std::size_t>(std::ceil(3.0 * sigma_px)); // of a Gaussian 99.7 %
}

// In two dimensions a term weighs a sqrt(pi / b) times the square of what its kernel weighed before it was
// made to weigh 1.
ContrastFilter contrastFilter(std::span<const Sensitivity> sensitivities, double pixelsPerDegree)
{
    const std::size_t radius = radiusFor(sigma_px(widest, pixelsPerDegree));
    ContrastFilter filter;
    double whole = 0.0;
    for (const auto& [a, b] : sensitivities) {
        ContrastFilter::Term term{gaussian(sigma_px(b, pixelsPerDegree), radius), 0.0};
        const double weighed = 1.0 / term.kernel[radius]; // the middle was 1
        term.share = a * std::sqrt(pi / b) * weighed * weighed;
        whole += term.share;
        filter.terms.push_back(std::move(term));
    }
    for (auto& term : filter.terms)
        term.share /= whole;
    return filter;
}

// Positive weights that sum to 1, and negative ones to -1 (section 4.2).
void balance(Kernel& kernel)
{
    double positive = 0.0, negative = 0.0;
    for (const double weight : kernel)
        (weight > 0.0 ? positive : negative) += std::abs(weight);
    for (double& weight : kernel)
        weight /= weight > 0.0 ? positive : negative;
}

} // namespace

FlipFilters flipFilters(double pixelsPerDegree)
{
    FlipFilters filters;
    filters.achromatic = contrastFilter(achromatic, pixelsPerDegree);
    filters.redGreen = contrastFilter(redGreen, pixelsPerDegree);
    filters.blueYellow = contrastFilter(blueYellow, pixelsPerDegree);
    // Edges are detected over 0.082 degrees from peak to trough, two standard deviations.
    const double sigma = 0.5 * 0.082 * pixelsPerDegree;
    const std::size_t radius = radiusFor(sigma);
    filters.smooth = gaussian(sigma, radius);
    filters.slope = filters.curvature = filters.smooth;
    for (std::size_t i = 0; i < filters.smooth.size(); ++i) {
        const double x = static_cast<double>(i) - static_cast<double>(radius);
        filters.slope[i] *= -x;
        filters.curvature[i] *= x * x / (sigma * sigma) - 1.0;
    }
    balance(filters.slope);
    balance(filters.curvature);
    filters.reach = std::max(radius, radiusOf(filters.achromatic.terms.front().kernel));
    return filters;
}

Plane filtered(const Plane& plane, const ContrastFilter& filter, std::size_t first, std::size_t rows)
{
    Plane sum(plane.width, rows);
    for (const auto& [kernel, share] : filter.terms) {
        const Plane term = convolved(plane, kernel, kernel, first, rows);
        for (std::size_t i = 0; i < sum.numbers.size(); ++i)
            sum.numbers[i] += share * term.numbers[i];
    }
    return sum;
}

} // namespace dioptre
