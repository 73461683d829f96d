#include "metric/psnr.h"

#include <cmath>
#include <limits>

namespace dioptre
{

double psnr_db(const PicturePair& encoded)
{
    double squares = 0.0;
    std::size_t numbers = 0;
    for (std::size_t i = 0; i < encoded.judged.size(); ++i) {
        if (encoded.judged[i] == 0)
            continue;
        const glm::dvec3 difference = glm::dvec3(encoded.picture[i]) - glm::dvec3(encoded.reference[i]);
        squares += glm::dot(difference, difference);
        numbers += 3;
    }
    if (numbers == 0)
        return std::numeric_limits<double>::quiet_NaN();
    if (squares == 0.0)
        return std::numeric_limits<double>::infinity();
    return 10.0 * std::log10(psnrPeak * psnrPeak * static_cast<double>(numbers) / squares);
}

} // namespace dioptre
