#include "render/view_picture.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

using Colour = std::array<int, 3>; // sRGB bytes

std::string hex(const Colour& colour)
{
    return fmt::format("#{:02x}{:02x}{:02x}", colour[0], colour[1], colour[2]);
}

// From few rays to many: dark to light, so that it reads in grey too.
constexpr std::array<Colour, 5> scale = {
    {{0x1c, 0x10, 0x44}, {0x6a, 0x1c, 0x81}, {0xc4, 0x3c, 0x4e}, {0xf6, 0x8d, 0x1e}, {0xfc, 0xfd, 0xbf}}};

// Calls change(rgb) for each pixel.
template <typename Change>
void eachPixel(Picture& picture, Change change)
{
    for (std::size_t i = 0; i < picture.floats.size(); i += 4)
        change(&picture.floats[i]);
}

struct Range {
    double low = std::numeric_limits<double>::max();
    double high = 0.0;
    double mean = 0.0;
};

// Of one channel over the pixels for which it is above 0; low is 0 where there is none.
Range rangeOf(const Picture& picture, std::size_t channel)
{
    Range range;
    double count = 0.0;
    for (std::size_t i = channel; i < picture.floats.size(); i += 4) {
        const double value = static_cast<double>(picture.floats[i]);
        if (!(value > 0.0))
            continue;
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
        range.mean += value;
        count += 1.0;
    }
    range.low = count > 0.0 ? range.low : 0.0;
    range.mean = count > 0.0 ? range.mean / (static_cast<double>(picture.floats.size()) / 4.0) : 0.0;
    return range;
}

// The scale's colour at 0..1 along it.
std::array<double, 3> scaleAt(double along)
{
    constexpr double last = scale.size() - 1;
    const double place = std::clamp(along, 0.0, 1.0) * last;
    const auto low = static_cast<std::size_t>(std::min(std::floor(place), last - 1.0));
    const double share = place - static_cast<double>(low);
    std::array<double, 3> colour{};
    for (std::size_t c = 0; c < 3; ++c)
        colour[c] = (scale[low][c] * (1.0 - share) + scale[low + 1][c] * share) / 255.0;
    return colour;
}

// Each further colour stands for the same factor: a budget of 16 has 1, 2, 4, 8, 16.
void showRays(ShownView& shown, int budget)
{
    const Range rays = rangeOf(shown.picture, 0);
    constexpr double last = scale.size() - 1;
    const double whole = budget > 1 ? std::log(budget) : 1.0;
    eachPixel(shown.picture, [&](float* rgb) {
        const auto colour = scaleAt(std::log(std::max(static_cast<double>(rgb[0]), 1.0)) / whole);
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(colour[c]);
    });
    auto& legend = shown.legend;
    legend.figures = {{"mean", rays.mean}, {"max", rays.high}, {"budget", budget}};
    legend.lines.push_back(fmt::format("rays traced a sample: mean {:.2f}, most {:.2f} in a pixel, budget {}",
                                       rays.mean, rays.high, budget));
    for (std::size_t i = 0; i < (budget > 1 ? scale.size() : 1); ++i)
        legend.lines.push_back(
            fmt::format("{}  {:.3g}", hex(scale[i]), std::pow(budget, static_cast<double>(i) / last)));
}

// Brightness by the logarithm, the same in every picture, so that little shows beside much and pictures
// compare.
void showLost(ShownView& shown)
{
    constexpr std::array<const char*, 3> causes = {"cut_off", "pool", "budget"};
    constexpr std::array<const char*, 3> meanings = {
        "red    below trace.cut_off", "green  fell out of the pool (a queue and a stack hold all)",
        "blue   the budget ran out, or the depth limit ended it"};
    constexpr float decades = 5.0F; // from black, 0.001 %, to full
    auto& legend = shown.legend;
    double all = 0.0;
    double most = 0.0;
    std::vector<std::string> lines;
    for (std::size_t c = 0; c < 3; ++c) {
        const Range range = rangeOf(shown.picture, c);
        all += range.mean;
        most = std::max(most, range.high);
        legend.figures.emplace_back(fmt::format("{}_percent", causes[c]), 100.0 * range.mean);
        lines.push_back(fmt::format("{}: mean {:.3g} %", meanings[c], 100.0 * range.mean));
    }
    eachPixel(shown.picture, [&](float* rgb) {
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = std::max(0.0F, 1.0F + std::log10(std::max(rgb[c], 1.0e-9F)) / decades);
    });
    legend.figures.emplace_back("max_percent", 100.0 * most);
    legend.lines.push_back(
        fmt::format("weight of rays that were not traced, in percent of all: mean {:.3g} %, "
                    "most of one cause {:.3g} % in a pixel",
                    100.0 * all, 100.0 * most));
    legend.lines.insert(legend.lines.end(), lines.begin(), lines.end());
    legend.lines.emplace_back(
        "brightness: 100 % full, 10 % 4/5, 1 % 3/5, 0.1 % 2/5, 0.01 % 1/5, 0.001 % black");
}

// Samples beyond trust in a colour that the scale does not have.
void showTrust(ShownView& shown)
{
    constexpr Colour beyond = {0x00, 0xd0, 0xff};
    constexpr double most_bits = 24.0;
    const Range share = rangeOf(shown.picture, 0);
    const Range bits = rangeOf(shown.picture, 1);
    eachPixel(shown.picture, [&](float* rgb) {
        const auto outside = static_cast<double>(rgb[0]);
        const auto colour = scaleAt(static_cast<double>(rgb[1]) / most_bits);
        for (std::size_t c = 0; c < 3; ++c)
            rgb[c] = static_cast<float>(outside * beyond[c] / 255.0 + (1.0 - outside) * colour[c]);
    });
    auto& legend = shown.legend;
    legend.figures = {
        {"beyond_percent", 100.0 * share.mean}, {"bits_lost_mean", bits.mean}, {"bits_lost_most", bits.high}};
    legend.lines.push_back(
        fmt::format("beyond what single precision can tell: {:.3g} % of the picture; bits lost of 24: mean "
                    "{:.1f}, most {:.1f} in a pixel",
                    100.0 * share.mean, bits.mean, bits.high));
    legend.lines.push_back(hex(beyond) +
                           "  beyond: the place is uncertain by a tenth of what there is to see, or more");
    for (std::size_t i = 0; i < scale.size(); ++i)
        legend.lines.push_back(fmt::format("{}  {:.0f} bits", hex(scale[i]),
                                           most_bits * static_cast<double>(i) / (scale.size() - 1)));
}

// By the inverse of the distance, so that an endless floor leaves the near things apart: near is light, and
// black is where nothing is met.
void showDepth(ShownView& shown)
{
    constexpr double darkest = 0.2;
    const Range depth = rangeOf(shown.picture, 0);
    const double span = depth.high > depth.low ? 1.0 / depth.low - 1.0 / depth.high : 0.0;
    eachPixel(shown.picture, [&](float* rgb) {
        const double metres = static_cast<double>(rgb[0]);
        const double nearness = span > 0.0 ? (1.0 / metres - 1.0 / depth.high) / span : 1.0;
        std::fill_n(rgb, 3, metres > 0.0 ? static_cast<float>(darkest + (1.0 - darkest) * nearness) : 0.0F);
    });
    auto& legend = shown.legend;
    legend.figures = {{"nearest_m", depth.low}, {"farthest_m", depth.high}};
    legend.lines = {"metres along the ray from the eye to the first surface; the grey goes by their inverse"};
    for (int step = 4; step >= 0 && depth.high > 0.0; --step) {
        const double nearness = step / 4.0;
        const int byte = static_cast<int>(std::lround(255.0 * (darkest + (1.0 - darkest) * nearness)));
        legend.lines.push_back(
            fmt::format("{}  {:.4g} m", hex({byte, byte, byte}), 1.0 / (1.0 / depth.high + nearness * span)));
        if (span == 0.0)
            break; // one distance everywhere
    }
    legend.lines.emplace_back("#000000  nothing met (0 in EXR)");
}

const char* kindOf(const Primitive& primitive)
{
    constexpr std::array<const char*, std::variant_size_v<Primitive>> names = {
        "sphere", "cylinder", "plane", "disk", "rectangle", "triangle"};
    return names[primitive.index()];
}

void showObjects(ShownView& shown, const Scene& scene)
{
    auto& legend = shown.legend;
    legend.lines = {"objects by colour: number, name, kind", "#000000  nothing met"};
    for (std::size_t id = 0; id < scene.objects.size(); ++id) {
        const auto& object = scene.objects[id];
        legend.objects.push_back({hex(objectColour(id)), id, object.name, kindOf(object.primitive)});
        const auto& entry = legend.objects.back();
        legend.lines.push_back(fmt::format("{}  {:3}  {}{}{}", entry.colour, id, entry.name,
                                           entry.name.empty() ? "" : ", ", entry.kind));
    }
}

} // namespace

void dataFromSums(Picture& sums, DataView view, int samples)
{
    eachPixel(sums, [&](float* rgb) {
        if (view == DataView::rays)
            std::fill_n(rgb, 3, rgb[3]);
        if (view == DataView::depth)
            std::fill_n(rgb, 3, rgb[1] > 0.0F ? rgb[0] / rgb[1] * static_cast<float>(samples) : 0.0F);
    });
}

ShownView shownView(const Picture& data, const PreparedScene& prepared)
{
    ShownView shown{data, {}};
    switch (prepared.plan.view) {
    case DataView::rays:
        showRays(shown, prepared.packed.budget);
        break;
    case DataView::lost:
        showLost(shown);
        break;
    case DataView::trust:
        showTrust(shown);
        break;
    case DataView::object:
        showObjects(shown, prepared.scene);
        break;
    case DataView::normal:
        shown.legend.lines = {
            "normal n of the first surface, on the eye's side, as n/2 + 1/2 along the world's axes",
            "red    x: 0 to the left, 1/2 neither, 1 to the right", "green  y: 0 down, 1 up",
            "blue   z: 0 away from +z, 1 towards it", "#000000  nothing met"};
        break;
    case DataView::depth:
        showDepth(shown);
        break;
    case DataView::uv:
        shown.legend.lines = {
            "picture coordinates of the first surface, 0 to 1, where they go on from 0 again", "red    u",
            "green  v", "#000000  nothing met"};
        break;
    case DataView::number: // never shown to the eye
    case DataView::none:
        break;
    }
    return shown;
}

} // namespace dioptre
