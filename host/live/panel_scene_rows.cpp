#include "live/panel_scene_rows.h"

#include "live/panel_words.h"
#include "scene/choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

constexpr double mostLight = 1000.0; // radiance of a white wall
constexpr double farthest_m = 1000.0;
constexpr int mostDepth = 64; // as good as none

std::vector<double> numbersOf(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

void addLightColour(std::vector<PanelRow>& rows, const char* key, const glm::dvec3& colour)
{
    rows.push_back({.path = key,
                    .label = key,
                    .kind = RowKind::colour,
                    .numbers = numbersOf(colour),
                    .high = mostLight});
}

void addPlace(std::vector<PanelRow>& rows, const Light& light)
{
    const bool placed = light.kind == Light::Kind::point || light.kind == Light::Kind::spot;
    if (placed)
        rows.push_back({.path = "position",
                        .label = "position, m",
                        .kind = RowKind::vector,
                        .numbers = numbersOf(light.position),
                        .low = -farthest_m,
                        .high = farthest_m});
    if (light.kind == Light::Kind::directional || light.kind == Light::Kind::spot)
        rows.push_back({.path = "direction",
                        .label = "direction",
                        .kind = RowKind::vector,
                        .numbers = numbersOf(light.direction),
                        .low = -1.0,
                        .high = 1.0,
                        .nonZero = true,
                        .meaning = "along which the light travels"});
    if (placed)
        rows.push_back({.path = "attenuation",
                        .label = "attenuation",
                        .kind = RowKind::vector,
                        .numbers = numbersOf(light.attenuation),
                        .high = mostLight,
                        .nonZero = true,
                        .meaning = "constant, linear and quadratic in the distance in metres"});
}

void addCone(std::vector<PanelRow>& rows, const Light& light)
{
    if (light.kind != Light::Kind::spot)
        return;
    rows.push_back({.path = "cutoff_deg",
                    .label = "cutoff, deg",
                    .numbers = {light.cutoff_deg},
                    .high = 90.0,
                    .meaning = "half-angle of the cone; 180 is no cone"});
    rows.push_back({.path = "exponent",
                    .label = "exponent",
                    .numbers = {light.exponent},
                    .high = 128.0,
                    .logarithmic = true,
                    .meaning = "the light falls off as the cosine to this power"});
}

void addLimits(std::vector<PanelRow>& rows, const Trace& trace, int budget)
{
    rows.push_back({.path = "trace.budget",
                    .label = "budget",
                    .kind = RowKind::integer,
                    .numbers = {static_cast<double>(trace.budget.value_or(budget))},
                    .low = 1.0,
                    .high = 4096.0,
                    .logarithmic = true,
                    .meaning = "most rays a sample, the eye ray included"});
    rows.push_back({.path = "trace.depth",
                    .label = "depth",
                    .kind = RowKind::integer,
                    .numbers = {static_cast<double>(trace.depth.value_or(mostDepth))},
                    .high = mostDepth,
                    .unset = trace.depth ? "" : "no limit",
                    .meaning = "most bounces of a path"});
    rows.push_back({.path = "trace.cut_off",
                    .label = "cut-off",
                    .numbers = {trace.cutOff},
                    .high = 0.5,
                    .logarithmic = true,
                    .meaning = "a ray that weighs less is not traced"});
}

void addWays(std::vector<PanelRow>& rows, const Trace& trace)
{
    const auto choice = [&rows](const char* key, const char* label, double place, std::vector<RowWord> words,
                                const char* meaning) {
        rows.push_back({.path = fmt::format("trace.{}", key),
                        .label = label,
                        .kind = RowKind::choice,
                        .numbers = {place},
                        .high = static_cast<double>(words.size() - 1),
                        .words = std::move(words),
                        .meaning = meaning});
    };
    choice("order", "order", placeIn(treeOrders, trace.order), wordsOf(treeOrders),
           "of the ray tree; another compiles the shader anew");
    choice("form", "form", placeIn(sceneForms, trace.form), wordsOf(sceneForms),
           "of the scene in the shader; another compiles it anew");
    choice("light_type", "light type", static_cast<double>(trace.lightType),
           {{"0", "unlit"}, {"1", "lit"}, {"2", "lights only"}}, "");
}

std::vector<PanelRow> traceRows(const Trace& trace, int budget)
{
    std::vector<PanelRow> rows;
    addLimits(rows, trace, budget);
    addWays(rows, trace);
    for (PanelRow& row : rows)
        row.group = "Trace";
    return rows;
}

void addSky(std::vector<PanelRow>& rows, const Sky& sky, bool hasEffect)
{
    const std::size_t first = rows.size();
    constexpr std::array ends{"nadir", "horizon", "zenith"};
    const auto colour = [&](std::string path, const char* label, const glm::dvec3& value) {
        rows.push_back(
            {"Sky", "", std::move(path), label, RowKind::colour, numbersOf(value), 0.0, mostLight});
    };
    if (sky.kind == Sky::Kind::colour)
        colour("sky.colour", "colour", sky.colour);
    for (std::size_t i = 0; i < sky.gradient.size() && i < ends.size(); ++i)
        colour(fmt::format("sky.gradient.{}", i), ends[i], sky.gradient[i]);
    if (sky.kind == Sky::Kind::image) {
        rows.push_back({"Sky",
                        "",
                        "sky.rotation_deg",
                        "rotation, deg",
                        RowKind::number,
                        {sky.rotation_deg},
                        -180.0,
                        180.0});
        rows.push_back({"Sky", "", "sky.mirror_u", "mirrored", RowKind::toggle, {sky.mirrorU ? 1.0 : 0.0}});
    }
    // A file may have no [sky], which then says nothing of its light.
    if (sky.kind != Sky::Kind::colour || sky.colour != glm::dvec3(0.0))
        rows.push_back(
            {"Sky", "", "sky.exposure", "exposure, stops", RowKind::number, {sky.exposure}, -10.0, 10.0});
    for (std::size_t i = first; i < rows.size(); ++i)
        rows[i].hasEffect = hasEffect;
}

// Values beyond a row's range are as good as those within, but for a cone's 180 degrees.
void widen(PanelRow& row)
{
    if (row.kind == RowKind::choice || row.kind == RowKind::toggle || row.path.ends_with(".cutoff_deg"))
        return;
    for (const double number : row.numbers) {
        row.low = std::min(row.low, number);
        row.high = std::max(row.high, number);
    }
}

} // namespace

bool isAnimated(const Scene& scene, std::string_view path)
{
    return std::ranges::any_of(scene.animated, [&](const auto& other) { return overlap(path, other); });
}

std::vector<PanelRow> lightRows(const Scene& scene, std::size_t index)
{
    const Light& light = scene.lights[index];
    constexpr std::array kinds{"ambient", "directional", "point", "spot"};
    std::vector<PanelRow> rows;
    addPlace(rows, light);
    addLightColour(rows, "ambient", light.ambient);
    if (light.kind != Light::Kind::ambient) {
        addLightColour(rows, "diffuse", light.diffuse);
        addLightColour(rows, "specular", light.specular);
    }
    addCone(rows, light);
    for (PanelRow& row : rows) {
        row.group = "Lights";
        row.section = fmt::format("{} {}", index, kinds[static_cast<std::size_t>(light.kind)]);
        row.hasEffect = scene.trace.lightType == LightType::lit ||
                        (scene.trace.lightType == LightType::lightsOnly && row.label != "ambient");
        row.path = fmt::format("light.{}.{}", index, row.path);
    }
    return rows;
}

std::vector<PanelRow> sceneRows(const Scene& scene, int budget)
{
    std::vector<PanelRow> rows;
    const auto append = [&rows](std::vector<PanelRow> more) {
        rows.insert(rows.end(), std::move_iterator(more.begin()), std::move_iterator(more.end()));
    };
    for (std::size_t i = 0; i < scene.lights.size(); ++i)
        append(lightRows(scene, i));
    for (std::size_t i = 0; i < scene.materials.size(); ++i)
        append(materialRows(scene, i));
    append(traceRows(scene.trace, budget));
    addSky(rows, scene.sky, scene.trace.lightType != LightType::lightsOnly);
    for (PanelRow& row : rows) {
        widen(row);
        if (isAnimated(scene, row.path))
            row.fixedBy = "animated";
    }
    return rows;
}

} // namespace dioptre
