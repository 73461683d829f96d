#include "command/method_drawing.h"

namespace dioptre
{

MethodDrawing methodDrawing(const Scene& scene, const ViewSettings& view, const Method& method,
                            const ContextInfo& context)
{
    MethodDrawing made;
    if (isRasterised(method)) {
        made.rasterised = std::make_unique<RasterScene>(prepareRaster(scene, view, method));
        made.drawing = std::make_unique<RasterRenderer>(*made.rasterised, view);
    } else {
        made.traced = std::make_unique<PreparedScene>(prepare(scene, view));
        made.drawing = std::make_unique<Renderer>(*made.traced, view, context);
    }
    return made;
}

} // namespace dioptre
