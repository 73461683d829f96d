#include "scene/sections.h"

#include "scene/table_reader.h"

#include <fmt/format.h>

namespace dioptre
{

namespace
{

Sky::Kind kindOf(const TableReader& reader)
{
    constexpr std::pair<std::string_view, Sky::Kind> kinds[] = {
        {"colour", Sky::Kind::colour}, {"gradient", Sky::Kind::gradient}, {"image", Sky::Kind::image}};
    const std::pair<std::string_view, Sky::Kind>* chosen = nullptr;
    for (const auto& kind : kinds) {
        if (!reader.find(kind.first))
            continue;
        if (chosen)
            fail(ExitCode::badInput, reader.where(kind.first),
                 fmt::format("[sky] has both {} and {}", chosen->first, kind.first), "keep one of them");
        chosen = &kind;
    }
    if (!chosen)
        fail(ExitCode::badInput, reader.where(), "[sky] says nothing of its light",
             "add one of colour, gradient, image");
    return chosen->second;
}

} // namespace

Sky readSky(const Table& document, const Search& pictures)
{
    Sky sky;
    const Value* section = find(document, "sky");
    if (!section)
        return sky;
    const TableReader reader(
        *section, "[sky]",
        {"colour", "gradient", "image", "encoding", "rotation_deg", "mirror_u", "exposure"});
    sky.kind = kindOf(reader);
    reader.colour("colour", sky.colour);
    if (const Value* gradient = reader.find("gradient"))
        sky.gradient = coloursFrom(*gradient, "gradient", 3);
    if (const Value* image = reader.find("image"))
        sky.image = pictureFile(*image, "image", pictures);
    for (std::string_view key : {"encoding", "rotation_deg", "mirror_u"})
        reader.refuseUnless(sky.kind == Sky::Kind::image, key, "on a sky without image", "take it out");
    reader.choice<Encoding>("encoding", sky.encoding,
                            {{"srgb", Encoding::srgb}, {"linear", Encoding::linear}});
    reader.number("rotation_deg", sky.rotation_deg, anyNumber);
    reader.flag("mirror_u", sky.mirrorU);
    reader.number("exposure", sky.exposure, {-100.0, 100.0, false, "a number of stops from -100 to 100"});
    return sky;
}

} // namespace dioptre
