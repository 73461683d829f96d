#include "metric/flip.h"

#include "metric/band.h"
#include "metric/flip_colour.h"
#include "metric/flip_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre
{
namespace
{

// A band of a picture in YyCxCz, with `reach` rows more on either side.
struct Opponents {
    Plane achromatic, redGreen, blueYellow;
};

Opponents opponentsOf(const std::vector<glm::vec3>& colours, std::size_t width, const Band& band,
                      std::size_t reach)
{
    const std::size_t rows = band.rows + 2 * reach, height = colours.size() / width;
    Opponents opponents{{width, rows}, {width, rows}, {width, rows}};
    for (std::size_t row = 0; row < rows; ++row) {
        const auto offset = static_cast<std::ptrdiff_t>(row) - static_cast<std::ptrdiff_t>(reach);
        const glm::vec3* colour = colours.data() + nearestRow(band.first, offset, height) * width;
        for (std::size_t x = 0; x < width; ++x) {
            const glm::dvec3 opponent = opponentFromRgb(colour[x]);
            opponents.achromatic.row(row)[x] = opponent.x;
            opponents.redGreen.row(row)[x] = opponent.y;
            opponents.blueYellow.row(row)[x] = opponent.z;
        }
    }
    return opponents;
}

// How strong an edge or a point each pixel of a band is: lengths of the responses along rows and columns.
struct Features {
    Plane edges, points;
};

Plane lengths(const Plane& alongX, const Plane& alongY)
{
    Plane result(alongX.width, alongX.height);
    for (std::size_t i = 0; i < result.numbers.size(); ++i)
        result.numbers[i] =
            std::sqrt(alongX.numbers[i] * alongX.numbers[i] + alongY.numbers[i] * alongY.numbers[i]);
    return result;
}

// Of the achromatic channel in 0..1, y of white-relative XYZ (section 4.2).
Features featuresOf(Plane achromatic, const FlipFilters& filters, std::size_t rows)
{
    for (double& number : achromatic.numbers)
        number = (number + 16.0) / 116.0;
    const Plane smooth = alongColumns(achromatic, filters.smooth, filters.reach, rows);
    const auto response = [&](const Kernel& kernel) {
        return lengths(alongRows(smooth, kernel),
                       convolved(achromatic, kernel, filters.smooth, filters.reach, rows));
    };
    return {response(filters.slope), response(filters.curvature)};
}

// What the eye's filters leave of a band: colours in linear RGB, 0..1.
std::vector<glm::dvec3> seenColours(const Opponents& opponents, const FlipFilters& filters, std::size_t rows)
{
    const Plane yy = filtered(opponents.achromatic, filters.achromatic, filters.reach, rows),
                cx = filtered(opponents.redGreen, filters.redGreen, filters.reach, rows),
                cz = filtered(opponents.blueYellow, filters.blueYellow, filters.reach, rows);
    std::vector<glm::dvec3> colours;
    colours.reserve(yy.width * rows);
    for (std::size_t row = 0; row < rows; ++row)
        for (std::size_t x = 0; x < yy.width; ++x)
            colours.push_back(
                glm::clamp(rgbFromOpponent({yy.row(row)[x], cx.row(row)[x], cz.row(row)[x]}), 0.0, 1.0));
    return colours;
}

struct Seen {
    std::vector<glm::dvec3> colours;
    Features features;
};

Seen seen(const std::vector<glm::vec3>& colours, std::size_t width, const Band& band,
          const FlipFilters& filters)
{
    Opponents opponents = opponentsOf(colours, width, band, filters.reach);
    auto seenThere = seenColours(opponents, filters, band.rows);
    return {std::move(seenThere), featuresOf(std::move(opponents.achromatic), filters, band.rows)};
}

// Section 4.3: where features differ, a difference in colour counts for more.
void judgeBand(const Seen& reference, const Seen& picture, float* errors)
{
    constexpr double exponent = 0.5; // q_f
    const std::size_t width = reference.features.edges.width;
    for (std::size_t i = 0; i < reference.colours.size(); ++i) {
        const std::size_t x = i % width, row = i / width;
        const auto differenceOf = [&](Plane Features::*feature) {
            return std::abs((reference.features.*feature).row(row)[x] -
                            (picture.features.*feature).row(row)[x]);
        };
        const double feature = std::pow(
            std::max(differenceOf(&Features::edges), differenceOf(&Features::points)) / std::numbers::sqrt2,
            exponent);
        const double colour = colourDifference(reference.colours[i], picture.colours[i]);
        errors[i] = static_cast<float>(std::pow(colour, 1.0 - feature));
    }
}

} // namespace

std::vector<float> ldrFlip(const PicturePair& displayed, double pixelsPerDegree)
{
    const FlipFilters filters = flipFilters(pixelsPerDegree);
    const auto width = static_cast<std::size_t>(displayed.width),
               height = static_cast<std::size_t>(displayed.height);
    std::vector<float> errors(width * height);
    inParallel(bandCount(height), [&](std::size_t i) {
        const Band band = bandOf(height, i);
        judgeBand(seen(displayed.reference, width, band, filters),
                  seen(displayed.picture, width, band, filters), errors.data() + band.first * width);
    });
    return errors;
}

} // namespace dioptre
