// From a rasterised scene to the texts of its programs.
#pragma once

#include "raster/raster_scene.h"
#include "render/source_text.h"

#include <string>
#include <vector>

namespace dioptre
{

// Both stages of a program, and all that they are fed: uniforms outside blocks, textures, and blocks.
struct RasterText {
    SourceText vertex; // empty: the full-screen triangle
    SourceText fragment;
    std::vector<std::string> fed;
};

struct RasterTexts {
    RasterText surface; // of the objects
    RasterText sky;     // behind them
    RasterText caster;  // of shadow maps; empty where there are none
    RasterText wire;    // of the facets' edges; empty without objects
    RasterText add;     // of samples to their sums
};

// Those that are not empty.
std::vector<RasterText> textsOfAll(const RasterTexts& texts);

// What they are assembled from, whatever the scene, as an #include names it.
std::vector<std::string> rasterSources();

// Throws badInput or inputMissing for faults in glsl/.
RasterTexts rasterTexts(const RasterScene& raster, const std::filesystem::path& glslFolder);

} // namespace dioptre
