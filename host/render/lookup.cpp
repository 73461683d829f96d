#include "render/lookup.h"

#include "render/literal.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

namespace dioptre
{
namespace
{

using Values = std::vector<std::optional<std::string>>;

// "name < 3 ? a : name < 5 ? b : c": a value that does not matter takes its neighbour's.
std::vector<std::string> rangeSteps(const std::string& name, const Values& values, std::string& last)
{
    std::vector<std::string> steps;
    std::optional<std::string> current;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!values[i] || values[i] == current)
            continue;
        if (current)
            steps.push_back(fmt::format("{} < {} ? {} :", name, i, *current));
        current = values[i];
    }
    last = *current;
    return steps;
}

// "name == 4 ? a : b" with the most frequent value last.
std::vector<std::string> equalitySteps(const std::string& name, const Values& values, std::string& last)
{
    std::map<std::string, std::size_t> counts;
    for (const auto& value : values)
        if (value)
            ++counts[*value];
    last = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; })->first;
    std::vector<std::string> steps;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] && *values[i] != last)
            steps.push_back(fmt::format("{} == {} ? {} :", name, i, *values[i]));
    return steps;
}

} // namespace

std::string selectText(const std::string& name, std::size_t count,
                       const std::function<std::optional<std::string>(std::size_t)>& valueOf,
                       const std::string& rest)
{
    Values values;
    for (std::size_t i = 0; i < count; ++i)
        values.push_back(valueOf(i));
    if (std::ranges::none_of(values, [](const auto& value) { return value.has_value(); }))
        return rest;
    std::string lastOfRanges;
    std::string lastOfEqualities;
    auto ranges = rangeSteps(name, values, lastOfRanges);
    auto equalities = equalitySteps(name, values, lastOfEqualities);
    const bool byRanges = ranges.size() <= equalities.size();
    std::string text;
    for (const auto& step : byRanges ? ranges : equalities)
        text += (text.empty() ? "" : "\n        ") + step;
    return text + (text.empty() ? "" : "\n        ") + (byRanges ? lastOfRanges : lastOfEqualities);
}

namespace
{

bool isCylinder(int kind)
{
    return kind == packed::KIND_OPEN_CYLINDER || kind == packed::KIND_CAPPED_CYLINDER;
}

bool hasEdges(int kind)
{
    return kind == packed::KIND_RECTANGLE || kind == packed::KIND_TRIANGLE;
}

// Which parts of an object's Shape surface.glsl and normal.glsl read; `worn`: the object wears a picture or a
// pattern.
struct ShapeParts {
    bool anchor, anchor_w, axis, axis_w, along;
};

ShapeParts partsOf(int kind, bool worn)
{
    return {.anchor = true,
            .anchor_w = kind == packed::KIND_SPHERE || (worn && kind != packed::KIND_PLANE),
            .axis = kind != packed::KIND_SPHERE || worn,
            .axis_w = worn && (isCylinder(kind) || hasEdges(kind)),
            .along = worn};
}

// One row of Shape: its xyz and its w apart, for they matter to different objects.
std::string rowSelects(const PackedScene& packed, const Plan& plan, const ShapeRow& row,
                       const std::function<bool(std::size_t)>& needsXyz,
                       const std::function<bool(std::size_t)>& needsW)
{
    using Value = std::optional<std::string>;
    const auto count = packed.objects.size();
    const auto xyz = [&](std::size_t id) {
        return plan.seen[id] && needsXyz(id) ? Value(rowText(packed.objects[id], row, ".xyz")) : Value();
    };
    const auto w = [&](std::size_t id) {
        return plan.seen[id] && needsW(id) ? Value(rowText(packed.objects[id], row, ".w")) : Value();
    };
    return fmt::format("    shape.{0}.xyz = {1};\n    shape.{0}.w = {2};\n", row.name,
                       selectText("object", count, xyz, "vec3(0.0)"), selectText("object", count, w, "0.0"));
}

std::string shapeText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    const auto parts = [&](std::size_t id) {
        const auto& material = scene.materials[scene.objects[id].material];
        return partsOf(packed.objects[id].kind, plan.defines.contains("HAS_COORDINATES") && wears(material));
    };
    const auto row = [&](const ShapeRow& which, bool ShapeParts::*xyz, bool ShapeParts::*w) {
        return rowSelects(
            packed, plan, which, [&](std::size_t id) { return parts(id).*xyz; },
            [&](std::size_t id) { return parts(id).*w; });
    };
    return "// What is read of an object's geometry once it is met.\nShape shapeOf(int object)\n{\n    Shape "
           "shape;\n" +
           row({"anchor", &packed::Shape::anchor}, &ShapeParts::anchor, &ShapeParts::anchor_w) +
           row({"axis", &packed::Shape::axis}, &ShapeParts::axis, &ShapeParts::axis_w) +
           row({"along_u", &packed::Shape::along_u}, &ShapeParts::along, &ShapeParts::along) +
           row({"along_v", &packed::Shape::along_v}, &ShapeParts::along, &ShapeParts::along) +
           "    return shape;\n}\n\n";
}

std::string intFunction(const char* comment, const char* name, const PackedScene& packed, const Plan& plan,
                        const std::function<std::string(const PackedObject&)>& valueOf)
{
    const auto value = [&](std::size_t id) -> std::optional<std::string> {
        if (!plan.seen[id])
            return std::nullopt;
        return valueOf(packed.objects[id]);
    };
    return fmt::format("// {}\nint {}(int object)\n{{\n    return {};\n}}\n\n", comment, name,
                       selectText("object", packed.objects.size(), value, "0"));
}

std::string nameOfKind(const PackedObject& object)
{
    constexpr std::array names = {"KIND_SPHERE", "KIND_OPEN_CYLINDER", "KIND_CAPPED_CYLINDER", "KIND_PLANE",
                                  "KIND_DISK",   "KIND_RECTANGLE",     "KIND_TRIANGLE"};
    static_assert(names.size() == packed::KIND_COUNT);
    return names.at(static_cast<std::size_t>(object.kind));
}

std::string materialIndex(const PackedObject& object)
{
    return std::to_string(object.material);
}

} // namespace

std::string lookupText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    if (!plan.has("objects"))
        return absorptionText(scene, plan);
    return intFunction("An object's KIND_.", "kindOf", packed, plan, nameOfKind) +
           shapeText(scene, packed, plan) +
           intFunction("Index of an object's material.", "mediumOf", packed, plan, materialIndex) +
           materialText(scene, plan) + absorptionText(scene, plan);
}

} // namespace dioptre
