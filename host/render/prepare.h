// A scene made ready for a view of it: under its light type, planned, packed, its pictures loaded.
#pragma once

#include "base/picture_cache.h"
#include "kernel/packed_scene.h"
#include "render/picture_parts.h"

#include <algorithm>
#include <filesystem>
#include <functional>

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
    int widthAtOnce = 0;            // pixels of the picture that are drawn at once, see Drawing::show();
    int heightAtOnce = 0;           // 0: all
    double drawLimit_s = 30.0;      // that a draw may take: it is taken for endless then
};

// What of the picture a target holds.
inline int targetWidth(const ViewSettings& view)
{
    return view.widthAtOnce > 0 ? std::min(view.widthAtOnce, view.width) : view.width;
}
inline int targetHeight(const ViewSettings& view)
{
    return view.heightAtOnce > 0 ? std::min(view.heightAtOnce, view.height) : view.height;
}

struct PreparedScene {
    Scene scene; // under its light type, and less what its view does not ask for
    Plan plan;
    PackedScene packed;
    std::vector<PicturePart> parts; // of the picture, the fullest last
};

// Fills in the pictures of a packed scene, as loadPictures() does.
using PictureSource = std::function<void(const Scene&, const Plan&, PackedScene&)>;

// Throws badInput and inputMissing for faults in the scene's numbers and pictures. `pictures`: where they
// come from, in place of their files.
PreparedScene prepare(const Scene& scene, const ViewSettings& view, const PictureSource& pictures = {});

// The same scene at another time, or latched on itself after an edit that its shader outlasts, in place: its
// plan, shader, parts and pictures stay as they are. `view` is that of prepare(). Throws badInput for faults
// in the scene's numbers.
void moveTo(PreparedScene& prepared, const Scene& scene, const ViewSettings& view);

} // namespace dioptre
