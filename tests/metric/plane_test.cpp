// Convolution by a row and a column against the sum over all of a square.
#include "metric/plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

using namespace dioptre;

namespace
{

Plane randomPlane(std::size_t width, std::size_t height)
{
    Plane plane(width, height);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (double& value : plane.numbers)
        value = number(random); // the padding too: it must not matter
    return plane;
}

Kernel randomKernel(std::size_t size)
{
    Kernel kernel(size);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::ranges::generate(kernel, [&] { return number(random); });
    return kernel;
}

} // namespace

// Widths on both sides of whole lanes, and narrower than the kernel.
TEST(Plane, ConvolvedByColumnAndRow_IsTheSumOverTheSquare)
{
    for (const std::size_t width : {1U, 3U, 7U, 8U, 9U, 20U}) {
        const Plane plane = randomPlane(width, 13);
        const Kernel columns = randomKernel(5), rows = randomKernel(7);
        const Plane result = convolved(plane, columns, rows, 3, 8);
        ASSERT_EQ(result.width, width);
        ASSERT_EQ(result.height, 8U);
        for (std::size_t y = 0; y < 8; ++y)
            for (std::size_t x = 0; x < width; ++x) {
                double sum = 0.0;
                for (int j = -2; j <= 2; ++j)
                    for (int i = -3; i <= 3; ++i) {
                        const int column =
                            std::clamp(static_cast<int>(x) + i, 0, static_cast<int>(width) - 1);
                        sum += columns[static_cast<std::size_t>(j + 2)] *
                               rows[static_cast<std::size_t>(i + 3)] *
                               plane.row(static_cast<std::size_t>(static_cast<int>(y) + 3 + j))[column];
                    }
                EXPECT_NEAR(result.row(y)[x], sum, 1e-12) << x << " " << y << " of " << width;
            }
    }
}

TEST(Plane, Gaussian_WeighsOneAndFallsAsItsSigmaSays)
{
    const Kernel kernel = gaussian(1.5, 5);
    ASSERT_EQ(kernel.size(), 11U);
    EXPECT_NEAR(std::accumulate(kernel.begin(), kernel.end(), 0.0), 1.0, 1e-15);
    EXPECT_NEAR(kernel[8] / kernel[5], std::exp(-2.0), 1e-15); // at 3 = 2 sigma
    EXPECT_EQ(kernel[1], kernel[9]);
}
