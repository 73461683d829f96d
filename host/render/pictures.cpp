#include "render/pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace dioptre
{
namespace
{

// The value that 99.9 % of the sky does not exceed in any channel, weighted by solid angle; up to 0.4 % above
// it. Positive floats are ordered as their bits are, so a histogram over the upper 16 takes one pass where a
// sort of a large sky takes long.
double brightSky(const Picture& picture)
{
    constexpr int cellBits = 15; // sign, exponent and 8 bits of the mantissa are left
    std::vector<double> weights(std::size_t{1} << (31 - cellBits), 0.0);
    double total = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        const double weight = std::cos((((y + 0.5) / picture.height) - 0.5) * packed::PI);
        for (int x = 0; x < picture.width; ++x) {
            const auto texel = linearTexel(picture, x, y);
            const float brightest = std::max({texel[0], texel[1], texel[2], 0.0F});
            weights[std::bit_cast<std::uint32_t>(brightest) >> cellBits] += weight;
        }
        total += weight * picture.width;
    }
    double above = 0.0;
    for (auto cell = static_cast<std::uint32_t>(weights.size()); cell-- > 1;) {
        above += weights[cell];
        if (above >= 0.001 * total)
            return static_cast<double>(std::bit_cast<float>((cell + 1) << cellBits));
    }
    return 0.0;
}

// Renderers leave infinities where a sun exceeds their range: those become the largest half float. NaN is a
// fault.
Picture withFiniteTexels(Picture picture, const std::string& path)
{
    for (std::size_t i = 0; i < picture.floats.size(); ++i) {
        if (std::isnan(picture.floats[i])) {
            const auto texel = static_cast<int>(i / 4);
            fail(ExitCode::badInput, {path, 0, 0},
                 fmt::format("texel {}, {} from the lower left is not a number", texel % picture.width,
                             texel / picture.width),
                 "mend the picture");
        }
        picture.floats[i] = std::clamp(picture.floats[i], -65504.0F, 65504.0F);
    }
    return picture;
}

} // namespace

void loadPictures(const Scene& scene, const Plan& plan, PackedScene& packed)
{
    for (const auto& picture : plan.pictures)
        packed.pictures.push_back(
            mipmaps(withFiniteTexels(readPicture(picture.path, picture.encoding), picture.path)));
    if (plan.has("sky picture") && scene.sky.kind == Sky::Kind::image)
        packed.sky_picture.push_back(
            withFiniteTexels(readPicture(scene.sky.image, scene.sky.encoding), scene.sky.image));
}

void setCutOff(const Scene& scene, const Plan& plan, PackedScene& packed)
{
    if (plan.tree == RayTree::single)
        return; // no path is ever sent on, none is cut
    double sky = 0.0;
    for (const auto& colour : {packed.sky.colour, packed.sky.horizon, packed.sky.zenith})
        sky = std::max({sky, colour.x, colour.y, colour.z});
    if (!packed.sky_picture.empty())
        sky *= brightSky(packed.sky_picture.front());
    packed.cutOff = scene.trace.cutOff / brightestRadiance(scene, plan, sky);
}

} // namespace dioptre
