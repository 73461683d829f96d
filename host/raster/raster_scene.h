// A scene made ready for a rasterised method: its own plan, its own numbers, and what its lights see.
#pragma once

#include "raster/method.h"
#include "raster/shadow_views.h"
#include "render/prepare.h"

namespace dioptre
{

struct RasterScene {
    Method method;
    PreparedScene prepared;        // its plan's features are those of the rasterised method
    std::vector<bool> casts;       // by object, whether it stands in light's way
    std::vector<bool> allAround;   // by light, whether its shadow maps are six; the same at every time
    ShadowViews shadows;           // none where no shadow map is wanted
    glm::dvec3 eyeAbsorption{0.0}; // per metre, of the medium that the eye is in
    double near_m = 0.0;           // no surface is nearer to the eye, along its gaze
};

// `view` as of prepare(); its method of tracing, view and parts play no part. Throws badInput as prepare().
RasterScene prepareRaster(const Scene& scene, const ViewSettings& view, const Method& method,
                          const PictureSource& pictures = {});

// The same scene at another time, as moveTo() of a PreparedScene.
void moveTo(RasterScene& raster, const Scene& scene, const ViewSettings& view);

// Side of the square about a plane's point that is tessellated where the plane does not say: eight times as
// far as the eye or the farthest object's farthest place is from it.
double usualPatch_m(const Scene& scene, const Plane& plane);

} // namespace dioptre
