#include "scene/sections.h"

#include "scene/table_reader.h"

namespace dioptre
{
namespace
{

constexpr Range shadowMapSides{0.0, 4096.0, false, "0 for no shadows, or a whole number from 256 to 4096"};

int shadowMapSide(const Value& value)
{
    const double side = numberFrom(value, "shadow_map", shadowMapSides);
    if (side != 0.0 && (side < 256.0 || side != static_cast<int>(side)))
        refuse(value, "shadow_map", shadowMapSides.wanted);
    return static_cast<int>(side);
}

} // namespace

Raster readRaster(const Table& document)
{
    Raster raster;
    const Value* section = find(document, "raster");
    if (!section)
        return raster;
    const TableReader reader(*section, "[raster]",
                             {"shadow_map", "shadow_filter", "shadow_bias", "interfaces"});
    if (const Value* side = reader.find("shadow_map"))
        raster.shadowMap_px = shadowMapSide(*side);
    reader.choice<Raster::ShadowFilter>("shadow_filter", raster.shadowFilter, shadowFilters);
    reader.number("shadow_bias", raster.shadowBias, zeroOrMore);
    std::optional<int> interfaces;
    reader.integer("interfaces", interfaces, 1, 2);
    raster.interfaces = interfaces.value_or(raster.interfaces);
    return raster;
}

} // namespace dioptre
