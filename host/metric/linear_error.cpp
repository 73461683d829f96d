#include "metric/linear_error.h"

#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

struct Sums {
    double squares = 0.0;
    double magnitudes = 0.0;
    double relativeSquares = 0.0;
    std::size_t numbers = 0;
};

void add(Sums& sums, double reference, double error)
{
    const double relative = error / (std::abs(reference) + 0.01);
    sums.squares += error * error;
    sums.magnitudes += std::abs(error);
    sums.relativeSquares += relative * relative;
    ++sums.numbers;
}

} // namespace

LinearError linearError(const PicturePair& pair)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    LinearError error{none, none, none, none, 0, 0};
    Sums sums;
    for (int row = 0; row < pair.height; ++row) // from the top
        for (int x = 0; x < pair.width; ++x) {
            const auto i =
                static_cast<std::size_t>(pair.height - 1 - row) * static_cast<std::size_t>(pair.width) +
                static_cast<std::size_t>(x);
            if (pair.judged[i] == 0)
                continue;
            const glm::dvec3 truth(pair.reference[i]), difference = glm::dvec3(pair.picture[i]) - truth;
            for (int channel = 0; channel < 3; ++channel) {
                add(sums, truth[channel], difference[channel]);
                if (!(std::abs(difference[channel]) <= error.max)) { // the first one against NaN
                    error.max = std::abs(difference[channel]);
                    error.maxX_px = x;
                    error.maxY_px = row;
                }
            }
        }
    if (sums.numbers == 0)
        return error;
    const auto count = static_cast<double>(sums.numbers);
    error.rmse = std::sqrt(sums.squares / count);
    error.mae = sums.magnitudes / count;
    error.relmse = sums.relativeSquares / count;
    return error;
}

} // namespace dioptre
