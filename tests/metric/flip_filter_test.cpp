// FLIP's filters: what they weigh, and what they answer to a step and to a line.
#include "metric/flip.h"
#include "metric/flip_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

using namespace dioptre;

namespace
{

// 1 from column 40 on, of 81.
Plane step()
{
    Plane plane(81, 1);
    for (std::size_t x = 40; x < 81; ++x)
        plane.row(0)[x] = 1.0;
    return plane;
}

} // namespace

// sigma = 0.5 * 0.082 * 67 = 2.747 and sqrt(0.04 / 2) / pi * 67 = 3.016 pixels; three of them, rounded up.
TEST(FlipFilter, Radii_AreThreeSigmas)
{
    const FlipFilters filters = flipFilters(usualPixelsPerDegree);
    EXPECT_EQ(radiusOf(filters.slope), 9U);
    EXPECT_EQ(radiusOf(filters.curvature), 9U);
    EXPECT_EQ(radiusOf(filters.achromatic.terms.front().kernel), 10U);
    EXPECT_EQ(filters.reach, 10U);
    EXPECT_EQ(flipFilters(1.0).reach, 1U);
}

TEST(FlipFilter, Weights_AreBalanced)
{
    for (const double pixelsPerDegree : {1.0, 10.0, 67.0, 300.0}) {
        const FlipFilters filters = flipFilters(pixelsPerDegree);
        for (const auto* filter : {&filters.achromatic, &filters.redGreen, &filters.blueYellow}) {
            double shares = 0.0;
            for (const auto& term : filter->terms) {
                EXPECT_NEAR(std::accumulate(term.kernel.begin(), term.kernel.end(), 0.0), 1.0, 1e-12);
                shares += term.share;
            }
            EXPECT_NEAR(shares, 1.0, 1e-12);
        }
        for (const auto* kernel : {&filters.slope, &filters.curvature}) {
            double positive = 0.0, negative = 0.0;
            for (const double weight : *kernel)
                (weight > 0.0 ? positive : negative) += weight;
            EXPECT_NEAR(positive, 1.0, 1e-12) << pixelsPerDegree;
            EXPECT_NEAR(negative, -1.0, 1e-12) << pixelsPerDegree;
        }
    }
}

// On one side of the step lie all negative or all positive weights of the slope.
TEST(FlipFilter, Slope_AnswersAStepByOneAtItsFoot)
{
    const Plane response = alongRows(step(), flipFilters(usualPixelsPerDegree).slope);
    EXPECT_NEAR(std::abs(response.row(0)[39]), 1.0, 1e-12);
    EXPECT_NEAR(std::abs(response.row(0)[40]), 1.0, 1e-12);
    EXPECT_NEAR(response.row(0)[20], 0.0, 1e-12);
    EXPECT_NEAR(response.row(0)[70], 0.0, 1e-12);
    EXPECT_LT(std::abs(response.row(0)[36]), 1.0);
}

TEST(FlipFilter, Curvature_IgnoresARampAndAnswersALine)
{
    const Kernel curvature = flipFilters(usualPixelsPerDegree).curvature;
    Plane ramp(81, 1), line(81, 1);
    for (std::size_t x = 0; x < 81; ++x)
        ramp.row(0)[x] = static_cast<double>(x);
    line.row(0)[40] = 1.0;
    EXPECT_NEAR(alongRows(ramp, curvature).row(0)[40], 0.0, 1e-12);
    EXPECT_NEAR(alongRows(line, curvature).row(0)[40], curvature[9], 1e-15);
    EXPECT_LT(curvature[9], -0.15);
}

// Fine detail is seen in lightness, less of it in red and green, and least in blue and yellow.
TEST(FlipFilter, ColoursAreBlurredMoreThanLightness)
{
    Plane line(81, 21);
    for (std::size_t y = 0; y < 21; ++y)
        line.row(y)[40] = 1.0;
    const FlipFilters filters = flipFilters(usualPixelsPerDegree);
    const auto peak = [&](const ContrastFilter& filter) { return filtered(line, filter, 10, 1).row(0)[40]; };
    EXPECT_GT(peak(filters.achromatic), peak(filters.redGreen));
    EXPECT_GT(peak(filters.redGreen), 1.5 * peak(filters.blueYellow));
}
