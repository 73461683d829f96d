#include "kernel/sampler.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// The index of a texel, repeated or clamped into 0..count-1.
int wrapped(int index, int count, bool repeats)
{
    if (!repeats)
        return std::clamp(index, 0, count - 1);
    return ((index % count) + count) % count;
}

glm::dvec4 texel(const Picture& picture, int x, int y)
{
    const auto linear = linearTexel(picture, x, y);
    return {linear[0], linear[1], linear[2], linear[3]};
}

} // namespace

glm::dvec4 sampleBilinear(const Picture& picture, glm::dvec2 uv, Wrap wrap)
{
    const double x = uv.x * picture.width - 0.5;
    const double y = uv.y * picture.height - 0.5;
    const double left = std::floor(x);
    const double low = std::floor(y);
    const auto at = [&](int dx, int dy) {
        return texel(picture, wrapped(static_cast<int>(left) + dx, picture.width, true),
                     wrapped(static_cast<int>(low) + dy, picture.height, wrap == Wrap::both));
    };
    const glm::dvec4 below = glm::mix(at(0, 0), at(1, 0), x - left);
    const glm::dvec4 above = glm::mix(at(0, 1), at(1, 1), x - left);
    return glm::mix(below, above, y - low);
}

glm::dvec4 sampleTrilinear(const std::vector<Picture>& levels, glm::dvec2 uv, double level)
{
    const double clamped = std::clamp(level, 0.0, static_cast<double>(levels.size() - 1));
    const auto finer = static_cast<std::size_t>(clamped);
    const auto coarser = std::min(finer + 1, levels.size() - 1);
    return glm::mix(sampleBilinear(levels[finer], uv, Wrap::both),
                    sampleBilinear(levels[coarser], uv, Wrap::both), clamped - static_cast<double>(finer));
}

} // namespace dioptre
