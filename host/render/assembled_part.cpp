#include "render/assembled_part.h"

#include "render/shared_values.h"

#include <algorithm>

namespace dioptre
{
namespace
{

// The plan for what the part shows on this device.
Plan planFor(const PreparedScene& prepared, const PicturePart& part, ShaderDevice device)
{
    device.sharedVectors = std::min(mostSharedVectors, device.sharedVectors);
    const Plan& whole = prepared.plan;
    const bool asGuarded = !whole.choosesKernels() || whole.guard == device.guard;
    if (part.seen == whole.seen && vectorsOf(whole.shared) <= device.sharedVectors && asGuarded)
        return whole;
    return makePlan(prepared.scene, whole.view, device, part.seen);
}

} // namespace

std::vector<AssembledPart> assembleParts(const PreparedScene& prepared,
                                         const std::filesystem::path& glslFolder, const ShaderDevice& device)
{
    std::vector<AssembledPart> parts;
    for (const auto& part : prepared.parts) {
        const Plan plan = planFor(prepared, part, device);
        parts.push_back({part, plan, assemble(prepared.scene, plan, prepared.packed, glslFolder),
                         assembleVertex(plan, prepared.packed, glslFolder)});
    }
    return parts;
}

} // namespace dioptre
