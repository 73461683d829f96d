// The words that scene files use for the ways to trace, each with what it means. The loader reads its choices
// from these tables and `dioptre list` prints them, so neither knows a word that the other does not.
#pragma once

#include "scene/scene.h"

#include <array>
#include <string_view>

namespace dioptre
{

template <class Choice>
struct NamedChoice {
    std::string_view name; // as in a scene file
    Choice choice;
    std::string_view meaning; // a phrase for people
};

// [trace] order
inline constexpr std::array treeOrders{
    NamedChoice<TreeOrder>{"heaviest-first", TreeOrder::heaviestFirst,
                           "the ray that matters most next, from a pool of 3 or 4"},
    NamedChoice<TreeOrder>{"breadth-first", TreeOrder::breadthFirst, "all rays in a queue, bounce by bounce"},
    NamedChoice<TreeOrder>{"depth-first", TreeOrder::depthFirst,
                           "each ray to its end, the heavier of two first, the others on a stack"},
};

// [trace] form
inline constexpr std::array sceneForms{
    NamedChoice<SceneForm>{"literal", SceneForm::literal,
                           "each object's geometry stands in the shader as constants"},
    NamedChoice<SceneForm>{"loop", SceneForm::loop, "the shader reads the geometry from a table"},
};

// [raster] shadow_filter
inline constexpr std::array shadowFilters{
    NamedChoice<Raster::ShadowFilter>{"nearest", Raster::ShadowFilter::nearest,
                                      "lit or not, by the nearest texel of the shadow map"},
    NamedChoice<Raster::ShadowFilter>{"pcf", Raster::ShadowFilter::percentage,
                                      "percentage-closer: the share of nine texels that see the light"},
};

// [output] curve
inline constexpr std::array toneCurves{
    NamedChoice<ToneCurve>{"none", ToneCurve::none, "radiance beyond 1 is white"},
    NamedChoice<ToneCurve>{"reinhard", ToneCurve::reinhard,
                           "x / (1 + x) of each channel: nothing is ever quite white"},
    NamedChoice<ToneCurve>{"filmic", ToneCurve::filmic,
                           "Narkowicz's fit of the ACES curve: more contrast, white from 7.24"},
};

} // namespace dioptre
