// Which pictures share an array texture, and the function that samples them.
#pragma once

#include "kernel/packed_scene.h"
#include "render/plan.h"

#include <string>
#include <vector>

namespace dioptre
{

// Pictures of one format that share an array texture; a picture is a layer of its group. The first fills its
// layer, a smaller one lies in its layer's lower left corner. A fetch from each group is paid by every ray,
// wanted or not.
struct PictureGroup {
    std::vector<std::size_t> pictures; // indices into PackedScene::pictures, by layer
    std::string uniform;               // "u_pictures0"
};

// Groups in the order of their largest pictures. A picture joins a larger one unless it repeats along a side
// on which it is smaller, or would leave more than three quarters of its layer empty.
std::vector<PictureGroup> pictureGroups(const Plan& plan, const PackedScene& packed);

// Those that hold a picture that the plan's shader samples.
std::vector<PictureGroup> sampledGroups(const Plan& plan, const PackedScene& packed);

// The samplers, and pictureColour().
std::string picturesText(const Plan& plan, const PackedScene& packed);

} // namespace dioptre
