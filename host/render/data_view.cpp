#include "render/data_view.h"

#include "base/text.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{

const std::vector<DataViewRow>& dataViews()
{
    static const std::vector<DataViewRow> rows = {
        {DataView::rays, "rays", "rays traced a sample, from one to the budget"},
        {DataView::lost, "lost", "weight of the rays that were not traced, by cause"},
        {DataView::object, "object", "a colour for each object"},
        {DataView::normal, "normal", "the first surface's normal n as n/2 + 1/2"},
        {DataView::depth, "depth", "metres to the first surface"},
        {DataView::uv, "uv", "the first surface's picture coordinates"},
        {DataView::trust, "trust", "where single precision stops meaning anything"}};
    return rows;
}

std::vector<std::string> dataViewNames()
{
    std::vector<std::string> names;
    for (const auto& row : dataViews())
        names.emplace_back(row.name);
    return names;
}

DataView dataViewNamed(const std::string& name)
{
    if (name.empty())
        return DataView::none;
    for (const auto& row : dataViews())
        if (row.name == name)
            return row.view;
    fail(ExitCode::usage, "there is no view called '" + name + "'",
         "the views are " + join(dataViewNames(), ", "));
}

const DataViewRow& rowOf(DataView view)
{
    static const DataViewRow number = {DataView::number, "number", "each object's number"};
    if (view == DataView::number)
        return number;
    return *std::ranges::find(dataViews(), view, &DataViewRow::view);
}

bool showsFirstHit(DataView view)
{
    return view == DataView::object || view == DataView::normal || view == DataView::depth ||
           view == DataView::uv || view == DataView::number;
}

bool showsRayTree(DataView view)
{
    return view == DataView::rays || view == DataView::lost || view == DataView::trust;
}

Scene underView(Scene scene, DataView view)
{
    if (view == DataView::none)
        return scene;
    scene.lights.clear();
    scene.sky = {};
    for (auto& material : scene.materials) {
        material.emission = glm::dvec3(0.0);
        material.light = false;
        material.image.clear();
        if (view != DataView::trust) // a pattern is what a place must be known for
            material.checker.reset();
        if (!showsFirstHit(view))
            continue;
        material.mirror = 0.0;
        material.transmit = 0.0;
        material.absorption = glm::dvec3(0.0);
        if (view == DataView::uv)
            material.checker = Checker{}; // only what wears something has coordinates
    }
    if (showsFirstHit(view))
        scene.camera.inside.reset();
    for (auto& typical : scene.typical)
        typical = underView(std::move(typical), view);
    return scene;
}

std::array<int, 3> objectColour(std::size_t object)
{
    // Hues by the golden ratio stay apart for any number of objects; neighbours in number differ in strength
    // too.
    constexpr double golden = 0.6180339887498949;
    constexpr std::array<double, 3> saturations = {0.55, 0.85, 0.35};
    constexpr std::array<double, 3> values = {0.95, 0.70, 0.80};
    const double hue = 6.0 * std::fmod(0.08 + golden * static_cast<double>(object), 1.0);
    std::array<int, 3> colour{};
    for (std::size_t channel = 0; channel < 3; ++channel) {
        // 1 within a sixth of the circle around the channel's own hue, 0 beyond two sixths.
        const double turned = std::fmod(hue + 6.0 - 2.0 * static_cast<double>(channel), 6.0);
        const double share = std::clamp(std::abs(turned - 3.0) - 1.0, 0.0, 1.0);
        const double value = values[object % 3] * (1.0 - saturations[object % 3] * (1.0 - share));
        colour[channel] = static_cast<int>(std::lround(255.0 * value));
    }
    return colour;
}

} // namespace dioptre
