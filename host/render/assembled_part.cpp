#include "render/assembled_part.h"

#include "render/shared_values.h"

#include <algorithm>

namespace dioptre
{
namespace
{

// The plan for what the part shows, with no more through the vertex stage than the device carries.
Plan planFor(const PreparedScene& prepared, const PicturePart& part, int mostShared)
{
    const int most = std::min(mostSharedVectors, mostShared);
    const Plan& whole = prepared.plan;
    if (part.seen == whole.seen && vectorsOf(whole.shared) <= most)
        return whole;
    return makePlan(prepared.scene, whole.view, most, part.seen);
}

} // namespace

std::vector<AssembledPart> assembleParts(const PreparedScene& prepared,
                                         const std::filesystem::path& glslFolder, int mostShared)
{
    std::vector<AssembledPart> parts;
    for (const auto& part : prepared.parts) {
        const Plan plan = planFor(prepared, part, mostShared);
        parts.push_back({part, plan, assemble(prepared.scene, plan, prepared.packed, glslFolder),
                         assembleVertex(plan, prepared.packed, glslFolder)});
    }
    return parts;
}

} // namespace dioptre
