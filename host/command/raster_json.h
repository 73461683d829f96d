// What a rasterised picture took, for scripts.
#pragma once

#include "render/drawing.h"

#include <nlohmann/json.hpp>

namespace dioptre
{

inline nlohmann::ordered_json rasterJson(const RasterFacts& raster)
{
    return {{"objects_drawn", raster.drawn},
            {"objects_culled", raster.culled},
            {"triangles", raster.triangles},
            {"shadow_maps", raster.shadowMaps},
            {"shadow_map_px", raster.shadowMap_px}};
}

} // namespace dioptre
