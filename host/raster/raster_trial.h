// The programs of a rasterised scene as another process tries them.
#pragma once

#include "raster/raster_text.h"
#include "render/trial.h"

namespace dioptre
{

// `text`: one of the scene's. Its pictures must be loaded. Stages that place vertices are tried with the
// facets of the scene's first object, so that what they hand on is drawn too.
ProgramTrial trialOf(const RasterScene& raster, const RasterText& text);

} // namespace dioptre
