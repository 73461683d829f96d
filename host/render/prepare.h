// A scene made ready for a view of it: under its light type, planned, packed, its pictures loaded.
#pragma once

#include "base/picture_cache.h"
#include "kernel/packed_scene.h"
#include "render/picture_parts.h"

#include <filesystem>

namespace dioptre
{

// What is drawn of a scene, and from which sources.
struct ViewSettings {
    int width = 1280; // pixels
    int height = 720; // pixels
    int samples = 16; // a pixel
    std::filesystem::path glslFolder;
    PictureCache pictures{};        // none unless one is named
    DataView view = DataView::none; // data in place of light
};

struct PreparedScene {
    Scene scene; // under its light type, and less what its view does not ask for
    Plan plan;
    PackedScene packed;
    std::vector<PicturePart> parts; // of the picture, the fullest last
};

// Throws badInput and inputMissing for faults in the scene's numbers and pictures.
PreparedScene prepare(const Scene& scene, const ViewSettings& view);

// The same scene at another time, in place: its plan, shader, parts and pictures stay as they are. `view` is
// that of prepare(). Throws badInput for faults in the scene's numbers.
void moveTo(PreparedScene& prepared, const Scene& scene, const ViewSettings& view);

} // namespace dioptre
