// A scene drawn by any of the methods.
#pragma once

#include "raster/raster_renderer.h"
#include "render/renderer.h"

#include <memory>

namespace dioptre
{

struct MethodDrawing {
    std::unique_ptr<PreparedScene>
        traced; // these outlive the drawing; one of them is there, but of a plain shader
    std::unique_ptr<RasterScene> rasterised;
    std::unique_ptr<Drawing> drawing;

    const PreparedScene& prepared() const
    {
        return rasterised ? rasterised->prepared : *traced;
    }
};

// On the current context. Throws badInput, as prepare() and the renderers do.
MethodDrawing methodDrawing(const Scene& scene, const ViewSettings& view, const Method& method,
                            const ContextInfo& context);

} // namespace dioptre
