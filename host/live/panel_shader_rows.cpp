#include "live/panel_shader_rows.h"

#include <algorithm>
#include <cctype>

namespace dioptre
{
namespace
{

// The file of lines that the assembler wrote.
constexpr std::string_view generated = "generated";

// Keys, mouse and time move these.
bool isFedByHost(const std::string& name)
{
    static const HostNumbers fed = [] {
        PlainFrame all;
        all.live.lightType = LightType::lit;
        all.live.lightHeight_m = 0.0;
        all.live.camera = Camera{};
        return hostUniforms(all, 1, 1, {});
    }();
    return fed.contains(name);
}

bool saysColour(std::string text)
{
    std::ranges::transform(text, text.begin(),
                           [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
    return text.find("colour") != std::string::npos || text.find("color") != std::string::npos ||
           text.find("tint") != std::string::npos;
}

RowKind rowKindOf(const Annotation& annotation)
{
    const bool isUnit = annotation.low == 0.0 && annotation.high == 1.0;
    if (annotation.type.starts_with("b"))
        return RowKind::toggle;
    if (annotation.type.starts_with("i") || annotation.type.starts_with("u"))
        return RowKind::integer;
    if (annotation.type == "vec3" && isUnit && (saysColour(annotation.label) || saysColour(annotation.name)))
        return RowKind::colour;
    return annotation.defaults.size() > 1 ? RowKind::vector : RowKind::number;
}

std::string shortName(const std::string& name)
{
    std::string text = name.starts_with("u_") ? name.substr(2) : name;
    std::ranges::replace(text, '_', ' ');
    return text;
}

} // namespace

std::vector<PanelRow> shaderRows(const std::vector<Annotation>& annotations,
                                 const std::vector<std::string>& active, const PlainValues& given,
                                 const std::map<std::string, std::vector<double>>& sliders)
{
    std::vector<PanelRow> rows;
    for (const Annotation& annotation : annotations) {
        const std::string& name = annotation.name;
        const bool isAuthors = annotation.where.path != generated;
        if (!isAuthors || std::ranges::find(active, name) == active.end() || isFedByHost(name))
            continue;
        const auto slider = sliders.find(name);
        PanelRow row;
        row.group = "Uniforms";
        row.path = name;
        row.label = shortName(name);
        row.kind = rowKindOf(annotation);
        row.numbers = slider != sliders.end() ? slider->second : annotation.defaults;
        row.low = annotation.low;
        row.high = annotation.high;
        row.isEncoded = true;
        row.meaning = annotation.label;
        if (const auto fixed = given.find(name); fixed != given.end())
            row.fixedBy = "--set " + fixed->second;
        row.numbers.resize(annotation.defaults.size());
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace dioptre
