#include "metric/ssim.h"

#include "metric/band.h"
#include "metric/plane.h"

#include <limits>

namespace dioptre
{
namespace
{

constexpr std::size_t reach = ssimWindow_px / 2; // pixels from a window's middle to its edge

struct Mean {
    double sum = 0.0;
    std::size_t windows = 0;
};

double luminanceOf(const glm::vec3& colour)
{
    return glm::dot(glm::dvec3(colour), glm::dvec3(0.2126, 0.7152, 0.0722)); // ITU-R BT.709
}

// Means under the window around each pixel, of the band's rows.
struct Moments {
    Plane x, y, xx, yy, xy;
};

// `first` and `rows` are those of the windows' middles; `reach` rows lie on either side.
Moments momentsOf(const PicturePair& pair, std::size_t first, std::size_t rows)
{
    const auto width = static_cast<std::size_t>(pair.width);
    const std::size_t all = rows + 2 * reach;
    Moments products{{width, all}, {width, all}, {width, all}, {width, all}, {width, all}};
    for (std::size_t row = 0; row < all; ++row)
        for (std::size_t column = 0; column < width; ++column) {
            const std::size_t i = (first - reach + row) * width + column;
            const double x = luminanceOf(pair.reference[i]), y = luminanceOf(pair.picture[i]);
            products.x.row(row)[column] = x;
            products.y.row(row)[column] = y;
            products.xx.row(row)[column] = x * x;
            products.yy.row(row)[column] = y * y;
            products.xy.row(row)[column] = x * y;
        }
    const Kernel window = gaussian(ssimSigma_px, reach);
    const auto mean = [&](const Plane& plane) { return convolved(plane, window, window, reach, rows); };
    return {mean(products.x), mean(products.y), mean(products.xx), mean(products.yy), mean(products.xy)};
}

// Equation 13.
double similarity(double x, double y, double xx, double yy, double xy)
{
    constexpr double c1 = ssimK1 * ssimK1, c2 = ssimK2 * ssimK2;
    const double varianceX = xx - x * x, varianceY = yy - y * y, covariance = xy - x * y;
    return (2.0 * x * y + c1) * (2.0 * covariance + c2) /
           ((x * x + y * y + c1) * (varianceX + varianceY + c2));
}

Mean meanOfBand(const PicturePair& pair, std::size_t first, std::size_t rows)
{
    const Moments means = momentsOf(pair, first, rows);
    const auto width = static_cast<std::size_t>(pair.width);
    Mean mean;
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t column = reach; column + reach < width; ++column) {
            if (pair.judged[(first + row) * width + column] == 0)
                continue;
            mean.sum +=
                similarity(means.x.row(row)[column], means.y.row(row)[column], means.xx.row(row)[column],
                           means.yy.row(row)[column], means.xy.row(row)[column]);
            ++mean.windows;
        }
    return mean;
}

} // namespace

double ssim(const PicturePair& encoded)
{
    const bool fits = encoded.width >= ssimWindow_px && encoded.height >= ssimWindow_px;
    const std::size_t middles = fits ? static_cast<std::size_t>(encoded.height) - 2 * reach : 0;
    std::vector<Mean> means(bandCount(middles));
    inParallel(means.size(), [&](std::size_t i) {
        const Band band = bandOf(middles, i);
        means[i] = meanOfBand(encoded, reach + band.first, band.rows);
    });
    Mean all;
    for (const Mean& mean : means) {
        all.sum += mean.sum;
        all.windows += mean.windows;
    }
    return all.windows > 0 ? all.sum / static_cast<double>(all.windows)
                           : std::numeric_limits<double>::quiet_NaN();
}

} // namespace dioptre
