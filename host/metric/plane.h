// Numbers over pixels and their convolution by kernels that are products of a row and a column.
#pragma once

#include <cstddef>
#include <vector>

namespace dioptre
{

// Sums that run side by side, so that the compiler makes vectors of them.
inline constexpr std::size_t lanes = 8;

// One number a pixel, row by row. Rows are padded to whole lanes; what the padding holds means nothing.
struct Plane {
    Plane(std::size_t columns, std::size_t rows);

    double* row(std::size_t y);
    const double* row(std::size_t y) const;

    std::size_t width;
    std::size_t height;
    std::size_t stride; // numbers from a row to the next
    std::vector<double> numbers;
};

// An odd number of weights; the middle one is for the pixel itself, the ones before it for lower indices.
using Kernel = std::vector<double>;

std::size_t radiusOf(const Kernel& kernel);

// exp(-x^2 / (2 sigma^2)) at the whole numbers from -radius to radius, divided by their sum.
Kernel gaussian(double sigma_px, std::size_t radius);

// Each result is sum over k of kernel[k] * number at k - radius. Rows go on beyond their ends with their
// first and last number.
Plane alongRows(const Plane& plane, const Kernel& kernel);

// The same along columns, for the rows first to first + rows - 1 of the plane alone; the kernel must not
// reach beyond the plane from there.
Plane alongColumns(const Plane& plane, const Kernel& kernel, std::size_t first, std::size_t rows);

// By columns, then by rows.
Plane convolved(const Plane& plane, const Kernel& columns, const Kernel& rows, std::size_t first,
                std::size_t count);

} // namespace dioptre
