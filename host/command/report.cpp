#include "command/report.h"

#include "base/text.h"
#include "command/json_text.h"
#include "command/raster_json.h"
#include "render/prune.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace dioptre
{
namespace
{

struct ShaderSize {
    std::size_t characters = 0;
    std::size_t lines = 0;
    std::ptrdiff_t functions = 0;
};

ShaderSize sizeOf(const SourceText& shader)
{
    const auto items = itemsOf(shader);
    return {flatten(shader).size(), shader.size(),
            std::count_if(items.begin(), items.end(),
                          [](const auto& item) { return item.kind == ShaderItem::Kind::function; })};
}

std::string orNone(const std::vector<std::string>& names)
{
    return names.empty() ? "none" : join(names, ", ");
}

std::string planTable(const Plan& plan)
{
    std::string text;
    for (const auto& feature : plan.features)
        text += fmt::format("{:4} {:30} {}\n", feature.in ? "in" : "out", feature.name, feature.reason);
    return text;
}

// "sky 21.3 % in 4 rectangles; everything 78.7 % in 3 rectangles"
std::string partsText(const std::vector<DrawnPart>& parts)
{
    std::vector<std::string> texts;
    for (const auto& part : parts)
        texts.push_back(fmt::format("{} {:.1f} % in {} rectangle{}", part.name, 100.0 * part.share,
                                    part.rectangles, part.rectangles == 1 ? "" : "s"));
    return join(texts, "; ");
}

nlohmann::ordered_json partsJson(const std::vector<DrawnPart>& parts)
{
    auto json = nlohmann::ordered_json::array();
    for (const auto& part : parts)
        json.push_back({{"sees", part.name}, {"share", part.share}, {"rectangles", part.rectangles}});
    return json;
}

nlohmann::ordered_json viewJson(const std::string& name, const ViewLegend& legend)
{
    nlohmann::ordered_json json = {{"name", name}};
    for (const auto& [figure, value] : legend.figures)
        json[figure] = value;
    for (const auto& object : legend.objects)
        json["objects"].push_back(
            {{"colour", object.colour}, {"id", object.id}, {"name", object.name}, {"kind", object.kind}});
    return json;
}

} // namespace

std::string shaderText(const DrawnPart* part, const SourceText& shader)
{
    std::string text;
    if (part != nullptr) {
        const bool whole = std::ranges::count(part->plan.seen, false) == 0;
        text +=
            whole ? "// What the scene needs, and what was left out:\n"
                  : fmt::format("// What is needed where the picture shows {}, the rest of the scene casting "
                                "shadows alone, and\n// what was left out:\n",
                                part->name);
        for (const auto& line : linesOf(planTable(part->plan), ""))
            text += "//   " + line.text + "\n";
    }
    return text + flatten(shader);
}

Phases together(const Phases& a, const Phases& b)
{
    Phases sum;
    for (const auto phase : {&Phases::context, &Phases::load, &Phases::compile, &Phases::firstDraw,
                             &Phases::draw, &Phases::read, &Phases::write})
        sum.*phase = a.*phase + b.*phase;
    return sum;
}

std::string whyText(const Plan* plan, const StillReport& still)
{
    std::string text;
    if (plan != nullptr) {
        text += planTable(*plan);
        if (const auto& raster = still.facts.raster)
            text += fmt::format("\nobjects   {} drawn, {} outside the view; {} triangles\n", raster->drawn,
                                raster->culled, raster->triangles);
        else
            text += fmt::format("\nbudget    {} rays a sample\n", plan->budget);
    }
    if (still.facts.shader.empty())
        return text + "traced in double precision on the CPU: no shader, textures or uniforms on a device\n";
    const ShaderSize size = sizeOf(still.facts.shader);
    text += fmt::format("shader    {} characters, {} lines, {} functions\n", size.characters, size.lines,
                        size.functions);
    if (!still.facts.parts.empty())
        text += fmt::format("parts     {}\n", partsText(still.facts.parts));
    text += fmt::format("textures  {} ({:.1f} MiB)\n", orNone(still.facts.textures),
                        static_cast<double>(still.facts.textureBytes) / (1024.0 * 1024.0));
    text += fmt::format("uniforms  {}\n", orNone(still.facts.uniforms));
    text += fmt::format("blocks    {}\n", orNone(still.facts.blocks));
    if (still.beyondTrust)
        text += fmt::format("trust     {:.2g} % of the picture is beyond what single precision can tell\n",
                            100.0 * *still.beyondTrust);
    text += fmt::format("compile   {:.1f} ms, first draw {:.1f} ms\n", still.phases.compile,
                        still.phases.firstDraw);
    return text;
}

std::string jsonText(const RenderOptions& options, const StillReport& still, const ContextInfo& context,
                     const Plan* plan)
{
    const ShaderSize size = sizeOf(still.facts.shader);
    nlohmann::ordered_json json = {
        {"output", options.output},
        {"size", {options.width, options.height}},
        {"samples", options.samples},
        {"time_s", options.time_s},
        {"backend", context.backend},
        {"renderer", context.renderer},
        {"phases_ms",
         {{"context", still.phases.context},
          {"load", still.phases.load},
          {"compile", still.phases.compile},
          {"first_draw", still.phases.firstDraw},
          {"draw", still.phases.draw},
          {"read", still.phases.read},
          {"write", still.phases.write}}},
        {"total_ms", still.phases.total},
        {"rays_per_pixel", still.figures.raysPerPixel()},
        {"nonfinite_pixels", still.figures.counts.nonfinite},
        {"shader", {{"characters", size.characters}, {"lines", size.lines}, {"functions", size.functions}}},
        {"uniforms", still.facts.uniforms},
        {"blocks", still.facts.blocks},
        {"textures", still.facts.textures},
    };
    if (still.beyondTrust)
        json["beyond_trust"] = *still.beyondTrust;
    json["method"] = options.method;
    if (still.facts.raster)
        json["raster"] = rasterJson(*still.facts.raster);
    if (!options.tile.empty())
        json["tile"] = options.tile;
    if (still.figures.legend)
        json["view"] = viewJson(options.view, *still.figures.legend);
    if (plan != nullptr) {
        json["parts"] = partsJson(still.facts.parts);
        json["budget"] = plan->budget;
        for (const auto& feature : plan->features)
            json["plan"].push_back(
                {{"feature", feature.name}, {"in", feature.in}, {"reason", feature.reason}});
    }
    return jsonText(json);
}

} // namespace dioptre
