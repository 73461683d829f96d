// The rows of a scene: what of it the loader takes in place of what it is, and nothing that it refuses.
#pragma once

#include "live/panel_row.h"
#include "scene/scene.h"

namespace dioptre
{

// Lights, materials, trace and sky, in this order. `budget`: rays a sample where the scene says none. A
// material whose name no path can hold has no rows.
std::vector<PanelRow> sceneRows(const Scene& scene, int budget);

// Parts of it, before their ranges are widened to what the scene holds and what is animated is fixed.
std::vector<PanelRow> materialRows(const Scene& scene, std::size_t material);
std::vector<PanelRow> lightRows(const Scene& scene, std::size_t light);

// Whether [[animate]] changes what a path leads to, or a part of it.
bool isAnimated(const Scene& scene, std::string_view path);

} // namespace dioptre
