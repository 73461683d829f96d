// From where the lights of a scene look at it for their shadow maps.
#pragma once

#include "kernel/packed_scene.h"

#include <string>
#include <vector>

namespace dioptre
{

namespace packed
{
#define float double
#include "../glsl/raster/shadow_view.glsl"
#undef float

static_assert(sizeof(ShadowView) == 4 * sizeof(vec4));
} // namespace packed

// The views of a light: `first` in the list of all; one where it shines one way, six (+x, -x, +y, -y, +z, -z)
// where it shines all around.
struct LightViews {
    int first = 0;
    int count = 0;
    std::vector<bool> casts; // by object, whether it is drawn to the light's maps
};

struct ShadowViews {
    std::vector<packed::ShadowView> views;
    std::vector<LightViews> lights;   // by PackedScene::lights
    std::vector<packed::vec4> planes; // that shade: unit normal, and its dot product with the plane's point
    std::vector<int> planeOf;         // by object, its place among these; -1 for none
};

// By light, whether its maps are six whatever its cone is at the moment. `animated`: paths of what moves.
std::vector<bool> shineAllAround(const PackedScene& scene, const std::vector<std::string>& animated);

// `casts`: by object, whether it stands in light's way.
ShadowViews shadowViews(const PackedScene& scene, const std::vector<bool>& casts,
                        const std::vector<bool>& allAround);

} // namespace dioptre
