#include "metric/plane.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dioptre
{
namespace
{

std::size_t wholeLanes(std::size_t numbers)
{
    return (numbers + lanes - 1) / lanes * lanes;
}

// The sums over k of kernel[k] * from[k * step + lane], for as many lanes as there are.
void sumLanes(const Kernel& kernel, const double* from, std::size_t step, double* to)
{
    std::array<double, lanes> sums{};
    for (const double weight : kernel) {
        for (std::size_t lane = 0; lane < lanes; ++lane)
            sums[lane] += weight * from[lane];
        from += step;
    }
    for (std::size_t lane = 0; lane < lanes; ++lane)
        to[lane] = sums[lane];
}

} // namespace

Plane::Plane(std::size_t columns, std::size_t rows)
    : width(columns), height(rows), stride(wholeLanes(columns)), numbers(stride * rows)
{
}

double* Plane::row(std::size_t y)
{
    return numbers.data() + y * stride;
}

const double* Plane::row(std::size_t y) const
{
    return numbers.data() + y * stride;
}

std::size_t radiusOf(const Kernel& kernel)
{
    return kernel.size() / 2;
}

Kernel gaussian(double sigma_px, std::size_t radius)
{
    Kernel kernel(2 * radius + 1);
    double sum = 0.0;
    for (std::size_t i = 0; i < kernel.size(); ++i) {
        const double x = static_cast<double>(i) - static_cast<double>(radius);
        kernel[i] = std::exp(-x * x / (2.0 * sigma_px * sigma_px));
        sum += kernel[i];
    }
    for (double& weight : kernel)
        weight /= sum;
    return kernel;
}

Plane alongRows(const Plane& plane, const Kernel& kernel)
{
    const std::size_t radius = radiusOf(kernel);
    Plane result(plane.width, plane.height);
    std::vector<double> longer(plane.stride + 2 * radius); // the row with what goes on beyond its ends
    for (std::size_t y = 0; y < plane.height; ++y) {
        const double* row = plane.row(y);
        std::fill_n(longer.begin(), radius, row[0]);
        std::copy_n(row, plane.width, longer.begin() + static_cast<std::ptrdiff_t>(radius));
        std::fill(longer.begin() + static_cast<std::ptrdiff_t>(radius + plane.width), longer.end(),
                  row[plane.width - 1]);
        for (std::size_t x = 0; x < plane.stride; x += lanes)
            sumLanes(kernel, longer.data() + x, 1, result.row(y) + x);
    }
    return result;
}

Plane alongColumns(const Plane& plane, const Kernel& kernel, std::size_t first, std::size_t rows)
{
    Plane result(plane.width, rows);
    for (std::size_t y = 0; y < rows; ++y)
        for (std::size_t x = 0; x < plane.stride; x += lanes)
            sumLanes(kernel, plane.row(first + y - radiusOf(kernel)) + x, plane.stride, result.row(y) + x);
    return result;
}

Plane convolved(const Plane& plane, const Kernel& columns, const Kernel& rows, std::size_t first,
                std::size_t count)
{
    return alongRows(alongColumns(plane, columns, first, count), rows);
}

} // namespace dioptre
