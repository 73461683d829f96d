#include "live/panel_scene_rows.h"

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

std::vector<double> numbersOf(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

template <class Table>
std::vector<RowWord> wordsOf(const Table& table)
{
    std::vector<RowWord> words;
    for (const auto& row : table)
        words.push_back({fmt::format("\"{}\"", row.name), std::string(row.name)});
    return words;
}

template <class Table, class Choice>
double placeIn(const Table& table, Choice choice)
{
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].choice == choice)
            return static_cast<double>(i);
    return 0.0;
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

void addTrace(std::vector<PanelRow>& rows, const Trace& trace, int budget)
{
    const char* const group = "Trace";
    rows.push_back({group,
                    "",
                    "trace.budget",
                    "budget",
                    RowKind::integer,
                    {static_cast<double>(trace.budget.value_or(budget))},
                    1.0,
                    4096.0,
                    true});
    rows.back().meaning = "most rays a sample, the eye ray included";
    rows.push_back({group,
                    "",
                    "trace.depth",
                    "depth",
                    RowKind::integer,
                    {static_cast<double>(trace.depth.value_or(64))},
                    0.0,
                    64.0});
    rows.back().high = std::max(64.0, rows.back().numbers.front());
    rows.back().unset = trace.depth ? "" : "no limit";
    rows.back().meaning = "most bounces of a path";
    rows.push_back({group, "", "trace.cut_off", "cut-off", RowKind::number, {trace.cutOff}, 0.0, 0.5, true});
    rows.back().meaning = "a ray that weighs less is not traced";
    rows.push_back({group,
                    "",
                    "trace.order",
                    "order",
                    RowKind::choice,
                    {placeIn(treeOrders, trace.order)},
                    0.0,
                    static_cast<double>(treeOrders.size() - 1)});
    rows.back().words = wordsOf(treeOrders);
    rows.back().meaning = "of the ray tree; another compiles the shader anew";
    rows.push_back({group,
                    "",
                    "trace.form",
                    "form",
                    RowKind::choice,
                    {placeIn(sceneForms, trace.form)},
                    0.0,
                    static_cast<double>(sceneForms.size() - 1)});
    rows.back().words = wordsOf(sceneForms);
    rows.back().meaning = "of the scene in the shader; another compiles it anew";
    rows.push_back({group,
                    "",
                    "trace.light_type",
                    "light type",
                    RowKind::choice,
                    {static_cast<double>(trace.lightType)},
                    0.0,
                    2.0});
    rows.back().words = {{"0", "unlit"}, {"1", "lit"}, {"2", "lights only"}};
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
    addTrace(rows, scene.trace, budget);
    addSky(rows, scene.sky, scene.trace.lightType != LightType::lightsOnly);
    for (PanelRow& row : rows) {
        widen(row);
        if (isAnimated(scene, row.path))
            row.fixedBy = "animated";
    }
    return rows;
}

std::vector<PanelRow> outputRows(const Display& display)
{
    std::vector<PanelRow> rows;
    rows.push_back({"Output",
                    "",
                    "output.exposure",
                    "exposure, stops",
                    RowKind::number,
                    {display.exposure},
                    -10.0,
                    10.0});
    rows.push_back({"Output",
                    "",
                    "output.curve",
                    "curve",
                    RowKind::choice,
                    {placeIn(toneCurves, display.curve)},
                    0.0,
                    static_cast<double>(toneCurves.size() - 1)});
    rows.back().words = wordsOf(toneCurves);
    rows.push_back({"Output", "", "output.gamma", "transfer", RowKind::choice, {display.gamma ? 1.0 : 0.0}});
    rows.back().words = {{"\"srgb\"", "sRGB"}, {fmt::format("{}", display.gamma.value_or(2.2)), "a power"}};
    if (display.gamma)
        rows.push_back(
            {"Output", "", "output.gamma", "gamma", RowKind::number, {*display.gamma}, 0.1, 10.0, true});
    widen(rows.front());
    return rows;
}

Display withOutput(Display display, const PanelRow& row, const std::vector<double>& numbers)
{
    if (row.path == "output.exposure")
        display.exposure = numbers.front();
    else if (row.path == "output.curve")
        display.curve = toneCurves.at(static_cast<std::size_t>(numbers.front())).choice;
    else if (row.kind == RowKind::number)
        display.gamma = numbers.front();
    else if (numbers.front() == 0.0)
        display.gamma.reset();
    else
        display.gamma = display.gamma.value_or(2.2);
    return display;
}

std::vector<std::string> overridesOf(const Display& display)
{
    std::vector<std::string> overrides;
    for (const PanelRow& row : outputRows(display)) // a power is in two rows
        if (row.path != "output.gamma" || (row.kind == RowKind::number) == display.gamma.has_value())
            overrides.push_back(row.path + "=" + tomlOf(row, row.numbers));
    return overrides;
}

} // namespace dioptre
