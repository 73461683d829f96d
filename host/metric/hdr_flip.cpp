#include "metric/hdr_flip.h"

#include "base/parallel.h"
#include "base/statistics.h"
#include "metric/flip.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// (n2 x^2 + n1 x) / (d2 x^2 + d1 x + d0): Narkowicz, "ACES Filmic Tone Mapping Curve", 2016, with x already
// multiplied by 0.6.
constexpr double n2 = 0.6 * 0.6 * 2.51, n1 = 0.6 * 0.03;
constexpr double d2 = 0.6 * 0.6 * 2.43, d1 = 0.6 * 0.59, d0 = 0.14;

// The radiance that is tone mapped to t: the positive root of (n2 - t d2) x^2 + (n1 - t d1) x - t d0 = 0,
// whose product of roots is negative while t < n2 / d2.
double radianceMappedTo(double t)
{
    const double a = n2 - t * d2, b = n1 - t * d1, c = -t * d0;
    return (-b + std::sqrt(b * b - 4.0 * a * c)) / (2.0 * a);
}

std::vector<double> luminancesAboveZero(const std::vector<glm::vec3>& colours, std::vector<double>& all)
{
    all.clear();
    std::vector<double> above;
    for (const glm::vec3& colour : colours) {
        const glm::dvec3 light = glm::max(glm::dvec3(colour), 0.0);
        all.push_back(glm::dot(light, glm::dvec3(0.2126, 0.7152, 0.0722)));
        if (all.back() > 0.0)
            above.push_back(all.back());
    }
    return above;
}

std::vector<glm::vec3> judgedColours(const std::vector<glm::vec3>& colours,
                                     const std::vector<std::uint8_t>& judged)
{
    std::vector<glm::vec3> kept;
    for (std::size_t i = 0; i < colours.size(); ++i)
        if (judged[i] != 0)
            kept.push_back(colours[i]);
    return kept;
}

std::vector<glm::vec3> toneMapped(const std::vector<glm::vec3>& colours, int height, double exposure)
{
    const double scale = std::exp2(exposure);
    const std::size_t width = colours.size() / static_cast<std::size_t>(height);
    std::vector<glm::vec3> mapped(colours.size());
    inParallel(static_cast<std::size_t>(height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i)
            for (int channel = 0; channel < 3; ++channel)
                mapped[i][channel] = static_cast<float>(
                    flipToneMapped(std::max(scale * static_cast<double>(colours[i][channel]), 0.0)));
    });
    return mapped;
}

} // namespace

double flipToneMapped(double radiance)
{
    constexpr double bright = 1e6; // beyond which the quotient is n2 / d2 > 1 and the squares may overflow
    const double x = std::min(radiance, bright);
    return std::min((n2 * x + n1) * x / ((d2 * x + d1) * x + d0), 1.0);
}

ExposureRange flipExposures(const PicturePair& radiance)
{
    std::vector<double> all;
    std::vector<double> above = luminancesAboveZero(judgedColours(radiance.reference, radiance.judged), all);
    if (above.empty())
        above = luminancesAboveZero(judgedColours(radiance.picture, radiance.judged), all);
    if (above.empty())
        return {};
    const double overall = median(all), middle = overall > 0.0 ? overall : median(above);
    const double mapped = radianceMappedTo(0.85);
    ExposureRange range;
    range.start = std::log2(mapped / *std::ranges::max_element(above));
    range.stop = std::log2(mapped / middle);
    range.count = std::max(2, static_cast<int>(std::ceil(range.stop - range.start)));
    return range;
}

std::vector<float> hdrFlip(const PicturePair& radiance, double pixelsPerDegree, const ExposureRange& range,
                           const std::function<void(double)>& progress)
{
    std::vector<float> worst(radiance.reference.size());
    for (int i = 0; i < range.count; ++i) {
        const double share = static_cast<double>(i) / (range.count - 1);
        const double exposure = range.start + share * (range.stop - range.start);
        const PicturePair shown{radiance.width,
                                radiance.height,
                                toneMapped(radiance.reference, radiance.height, exposure),
                                toneMapped(radiance.picture, radiance.height, exposure),
                                {},
                                0,
                                0};
        const std::vector<float> errors = ldrFlip(shown, pixelsPerDegree);
        std::ranges::transform(worst, errors, worst.begin(), [](float a, float b) { return std::max(a, b); });
        progress(static_cast<double>(i + 1) / range.count);
    }
    return worst;
}

} // namespace dioptre
