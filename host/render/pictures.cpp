#include "render/pack.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

// The value that 99.9 % of the sky's texels do not exceed in any channel, weighted by solid angle.
double brightSky(const Picture& picture)
{
    std::vector<std::pair<double, double>> texels; // brightest channel, weight
    double total = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        const double weight = std::cos((((y + 0.5) / picture.height) - 0.5) * packed::PI);
        for (int x = 0; x < picture.width; ++x) {
            const auto texel = linearTexel(picture, x, y);
            texels.emplace_back(std::max({texel[0], texel[1], texel[2]}), weight);
            total += weight;
        }
    }
    std::sort(texels.rbegin(), texels.rend());
    double above = 0.0;
    for (const auto& [value, weight] : texels) {
        above += weight;
        if (above >= 0.001 * total)
            return value;
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
    if (plan.has("sky picture"))
        packed.sky_picture.push_back(
            withFiniteTexels(readPicture(scene.sky.image, scene.sky.encoding), scene.sky.image));
}

void setCutOff(const Scene& scene, const Plan& plan, PackedScene& packed)
{
    double sky = 0.0;
    for (const auto& colour : {packed.sky.colour, packed.sky.horizon, packed.sky.zenith})
        sky = std::max({sky, colour.x, colour.y, colour.z});
    if (!packed.sky_picture.empty())
        sky *= brightSky(packed.sky_picture.front());
    packed.cutOff = scene.trace.cutOff / brightestRadiance(scene, plan, sky);
}

} // namespace dioptre
