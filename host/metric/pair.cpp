#include "metric/pair.h"

#include "base/parallel.h"
#include "base/srgb.h"

#include <cmath>

namespace dioptre
{
namespace
{

std::vector<glm::vec3> coloursOf(const Picture& picture)
{
    const auto width = static_cast<std::size_t>(picture.width);
    std::vector<glm::vec3> colours(width * static_cast<std::size_t>(picture.height));
    inParallel(static_cast<std::size_t>(picture.height), [&](std::size_t y) {
        for (std::size_t x = 0; x < width; ++x) {
            const auto texel = linearTexel(picture, static_cast<int>(x), static_cast<int>(y));
            colours[y * width + x] = {texel[0], texel[1], texel[2]};
        }
    });
    return colours;
}

bool isFinite(const glm::vec3& colour)
{
    return std::isfinite(colour.r) && std::isfinite(colour.g) && std::isfinite(colour.b);
}

// Calls change(colour) for each colour, row by row on all cores.
template <typename Change>
void changeAll(std::vector<glm::vec3>& colours, int height, Change change)
{
    const std::size_t width = colours.size() / static_cast<std::size_t>(height);
    inParallel(static_cast<std::size_t>(height), [&](std::size_t y) {
        for (std::size_t i = y * width; i < (y + 1) * width; ++i)
            change(colours[i]);
    });
}

void display(std::vector<glm::vec3>& colours, int height, const Display& display)
{
    const double scale = std::exp2(display.exposure);
    changeAll(colours, height, [&](glm::vec3& colour) {
        for (int channel = 0; channel < 3; ++channel)
            colour[channel] =
                static_cast<float>(toned(display.curve, scale * static_cast<double>(colour[channel])));
    });
}

void encode(std::vector<glm::vec3>& colours, int height)
{
    changeAll(colours, height, [](glm::vec3& colour) {
        for (int channel = 0; channel < 3; ++channel)
            colour[channel] = static_cast<float>(srgbFromLinear(static_cast<double>(colour[channel])));
    });
}

} // namespace

PicturePair pairOf(const Picture& reference, const Picture& picture)
{
    PicturePair pair{reference.width, reference.height, coloursOf(reference), coloursOf(picture), {}, 0, 0};
    pair.judged.resize(pair.reference.size());
    for (std::size_t i = 0; i < pair.reference.size(); ++i) {
        const bool knownReference = isFinite(pair.reference[i]), knownPicture = isFinite(pair.picture[i]);
        pair.nonfiniteReference += knownReference ? 0 : 1;
        pair.nonfinitePicture += knownPicture ? 0 : 1;
        pair.judged[i] = knownReference && knownPicture ? 1 : 0;
        if (pair.judged[i] == 0)
            pair.reference[i] = pair.picture[i] = glm::vec3(0.0f);
    }
    return pair;
}

PicturePair displayed(PicturePair pair, const Display& reference, const Display& picture)
{
    display(pair.reference, pair.height, reference);
    display(pair.picture, pair.height, picture);
    return pair;
}

PicturePair encoded(PicturePair displayed)
{
    encode(displayed.reference, displayed.height);
    encode(displayed.picture, displayed.height);
    return displayed;
}

} // namespace dioptre
