#include "render/picture_groups.h"

#include "render/literal.h"
#include "render/lookup.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <numeric>

namespace dioptre
{
namespace
{

struct Size {
    int width = 0;  // texels
    int height = 0; // texels
};

Size sizeOf(const PackedScene& packed, std::size_t picture)
{
    return {packed.pictures[picture].front().width, packed.pictures[picture].front().height};
}

// The coarsest level at which a smaller picture still takes the share of its layer that it takes at level 0:
// sides that both halve without a remainder.
int coarsestExact(const Size& picture, const Size& layer)
{
    const auto halvings = [](int a, int b) {
        return a == b ? 31 : std::countr_zero(static_cast<unsigned>(a) | static_cast<unsigned>(b));
    };
    return std::min(halvings(picture.width, layer.width), halvings(picture.height, layer.height));
}

// Fewer levels than this would show: the picture would alias from afar.
constexpr int fewestExact = 6;

bool joins(const Plan& plan, const PackedScene& packed, std::size_t picture, std::size_t first)
{
    const Size size = sizeOf(packed, picture);
    const Size layer = sizeOf(packed, first);
    if (packed.pictures[picture].front().format != packed.pictures[first].front().format)
        return false;
    if (size.width == layer.width && size.height == layer.height)
        return true;
    const bool repeatsU = plan.pictureRepeats.at(picture).u;
    const bool repeatsV = plan.pictureRepeats.at(picture).v;
    const bool fits = (size.width == layer.width || (size.width < layer.width && !repeatsU)) &&
                      (size.height == layer.height || (size.height < layer.height && !repeatsV));
    const long area = static_cast<long>(size.width) * size.height;
    return plan.padPictures && fits && coarsestExact(size, layer) >= fewestExact &&
           4 * area >= static_cast<long>(layer.width) * layer.height;
}

// One value a picture, by selects on its index.
std::string byPicture(const PictureGroup& group, const std::function<std::string(std::size_t)>& valueOf)
{
    return selectText(
        "layer", group.pictures.size(),
        [&](std::size_t i) -> std::optional<std::string> { return valueOf(group.pictures[i]); }, "");
}

// Takes `colour` from one array if the picture is in it.
std::string fetchText(const PackedScene& packed, const PictureGroup& group)
{
    const Size layer = sizeOf(packed, group.pictures.front());
    const auto vec2 = [](double x, double y) { return fmt::format("vec2({}, {})", literal(x), literal(y)); };
    const auto size = [&](std::size_t picture) {
        const Size s = sizeOf(packed, picture);
        return vec2(s.width, s.height);
    };
    const auto coarsest = [&](std::size_t picture) {
        return literal(static_cast<double>(coarsestExact(sizeOf(packed, picture), layer)));
    };
    const bool padded = std::ranges::any_of(group.pictures, [&](std::size_t picture) {
        return size(picture) != vec2(layer.width, layer.height);
    });
    std::string layers = "-1";
    for (std::size_t i = group.pictures.size(); i-- > 0;)
        layers = fmt::format("picture == {} ? {} : {}", group.pictures[i], i, layers);
    std::string text = fmt::format("    {{\n        int layer = {};\n        vec2 size = {};\n"
                                   "        float level = pictureLevel(footprint, size);\n",
                                   layers, byPicture(group, size));
    if (padded)
        text += fmt::format("        level = min(level, {});\n", byPicture(group, coarsest));
    text += fmt::format("        vec2 place = withinPicture(uv, wraps, level, size){};\n",
                        padded ? " * (size / " + vec2(layer.width, layer.height) + ")" : "");
    return text + fmt::format("        vec3 texel = textureLod({}, vec3(place, float(layer)), level).xyz;\n"
                              "        colour = layer >= 0 ? texel : colour;\n    }}\n",
                              group.uniform);
}

} // namespace

std::vector<PictureGroup> pictureGroups(const Plan& plan, const PackedScene& packed)
{
    std::vector<std::size_t> order(packed.pictures.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, std::ranges::greater{}, [&](std::size_t picture) {
        const Size size = sizeOf(packed, picture);
        return static_cast<long>(size.width) * size.height;
    });
    std::vector<PictureGroup> groups;
    for (const auto picture : order) {
        auto group = std::ranges::find_if(
            groups, [&](const PictureGroup& g) { return joins(plan, packed, picture, g.pictures.front()); });
        if (group == groups.end()) {
            groups.push_back({{}, fmt::format("u_pictures{}", groups.size())});
            group = groups.end() - 1;
        }
        group->pictures.push_back(picture);
    }
    return groups;
}

std::vector<PictureGroup> sampledGroups(const Plan& plan, const PackedScene& packed)
{
    auto groups = pictureGroups(plan, packed);
    std::erase_if(groups, [&](const PictureGroup& group) {
        return std::ranges::none_of(group.pictures, [&](auto picture) { return plan.sampled.at(picture); });
    });
    return groups;
}

std::string picturesText(const Plan& plan, const PackedScene& packed)
{
    const auto groups = sampledGroups(plan, packed);
    std::string text;
    for (const auto& group : groups) {
        const Size size = sizeOf(packed, group.pictures.front());
        text += fmt::format("uniform sampler2DArray {}; // {} x {} texels\n", group.uniform, size.width,
                            size.height);
    }
    text +=
        "\n// Linear colour of a picture, white for none; `footprint` is a sample's size as a share of it.\n"
        "vec3 pictureColour(int picture, vec2 uv, vec2 wraps, vec2 footprint)\n{\n"
        "    vec3 colour = vec3(1.0);\n";
    for (const auto& group : groups)
        text += fetchText(packed, group);
    return text + "    return colour;\n}\n\n";
}

} // namespace dioptre
