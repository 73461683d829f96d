#include "render/pack.h"

#include "base/parallel.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

namespace dioptre
{
namespace
{

float brightestChannel(const Picture& picture, int x, int y)
{
    if (picture.format != PixelFormat::float32) {
        const auto texel = linearTexel(picture, x, y);
        return std::max({texel[0], texel[1], texel[2], 0.0F});
    }
    const auto index =
        static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x);
    const float* texel = picture.floats.data() + 4 * index;
    return std::max({texel[0], texel[1], texel[2], 0.0F});
}

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
            weights[std::bit_cast<std::uint32_t>(brightestChannel(picture, x, y)) >> cellBits] += weight;
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

[[noreturn]] void failNotANumber(const Picture& picture, const std::string& path)
{
    const auto found = std::find_if(picture.floats.begin(), picture.floats.end(),
                                    [](float number) { return std::isnan(number); });
    const auto texel = static_cast<int>((found - picture.floats.begin()) / 4);
    fail(ExitCode::badInput, {path, 0, 0},
         fmt::format("texel {}, {} from the lower left is not a number", texel % picture.width,
                     texel / picture.width),
         "mend the picture");
}

// Renderers leave infinities where a sun exceeds their range: those become the largest half float. NaN is a
// fault.
Picture withFiniteTexels(Picture picture, const std::string& path)
{
    const auto isNan = [](float number) { return std::isnan(number); };
    if (std::any_of(picture.floats.begin(), picture.floats.end(), isNan))
        failNotANumber(picture, path);
    for (float& number : picture.floats)
        number = std::clamp(number, -65504.0F, 65504.0F);
    return picture;
}

std::string nameOf(Encoding encoding)
{
    return encoding == Encoding::automatic ? "automatic" : encoding == Encoding::srgb ? "srgb" : "linear";
}

std::vector<Picture> loadMipmaps(const std::string& path, Encoding encoding, const PictureCache& cache)
{
    return cache.levelsOf(path, "mipmaps " + nameOf(encoding),
                          [&] { return mipmaps(withFiniteTexels(readPicture(path, encoding), path)); });
}

std::vector<Picture> loadSky(const Sky& sky, const PictureCache& cache)
{
    return cache.levelsOf(sky.image, "sky " + nameOf(sky.encoding), [&] {
        std::vector<Picture> levels; // no list of initialisers: that would copy the picture
        levels.push_back(withFiniteTexels(readPicture(sky.image, sky.encoding), sky.image));
        return levels;
    });
}

} // namespace

void loadSkyPicture(const Scene& scene, const Plan& plan, PackedScene& packed, const PictureCache& cache)
{
    if (plan.has("sky picture") && scene.sky.kind == Sky::Kind::image)
        packed.sky_picture = loadSky(scene.sky, cache);
}

void loadPictures(const Scene& scene, const Plan& plan, PackedScene& packed, const PictureCache& cache)
{
    packed.pictures.resize(plan.pictures.size());
    // The sky comes first: it takes longest.
    inParallel(1 + plan.pictures.size(), [&](std::size_t i) {
        if (i == 0)
            loadSkyPicture(scene, plan, packed, cache);
        else
            packed.pictures[i - 1] =
                loadMipmaps(plan.pictures[i - 1].path, plan.pictures[i - 1].encoding, cache);
    });
}

void setCutOff(const Scene& scene, const Plan& plan, PackedScene& packed)
{
    if (plan.tree == RayTree::single)
        return; // no path is ever sent on, none is cut
    double sky = 0.0;
    for (const auto& colour : {packed.sky.colour, packed.sky.horizon, packed.sky.zenith})
        sky = std::max({sky, colour.x, colour.y, colour.z});
    if (!packed.sky_picture.empty() && !packed.skyPictureBrightness)
        packed.skyPictureBrightness = brightSky(packed.sky_picture.front());
    sky *= packed.skyPictureBrightness.value_or(1.0);
    packed.cutOff = scene.trace.cutOff / brightestRadiance(scene, plan, sky);
}

} // namespace dioptre
