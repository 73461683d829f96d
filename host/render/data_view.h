// Data in place of light: what of a scene's tracing `--view` shows.
#pragma once

#include "scene/scene.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

enum class DataView {
    none,
    rays,
    lost,
    object,
    normal,
    depth,
    uv,
    trust,
    number // an object's number plus 1, 0 where nothing is met: for layers alone, --view does not know it
};

struct DataViewRow {
    DataView view;
    const char* name;  // as --view takes it
    const char* shows; // in half a sentence
};

// Every view that --view knows, in the order of the help.
const std::vector<DataViewRow>& dataViews();

std::vector<std::string> dataViewNames();

// none for "". Throws usage for a name that is not there.
DataView dataViewNamed(const std::string& name);
const DataViewRow& rowOf(DataView view); // not none

// Whether only what a pixel's ray meets first is asked for.
bool showsFirstHit(DataView view);

// Whether the ray tree is followed for its weights or its certainty, and not for light.
bool showsRayTree(DataView view);

// The scene less what the view does not ask for: no light, sky, emission or picture; for views of the first
// hit no further rays either. For uv every object has coordinates.
Scene underView(Scene scene, DataView view);

// An object's colour in the object view, by its number alone: never black, and no two of the first two
// hundred are alike; sRGB bytes.
std::array<int, 3> objectColour(std::size_t object);

} // namespace dioptre
