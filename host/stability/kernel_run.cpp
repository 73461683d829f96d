#include "stability/kernel_run.h"

#include <array>
#include <map>
#include <set>

namespace dioptre
{
namespace
{

std::set<std::string> featuresOf(int primitive, Variant variant)
{
    constexpr std::array kinds = {"HAS_SPHERE", "HAS_OPEN_CYLINDER", "HAS_CAPPED_CYLINDER", "HAS_PLANE",
                                  "HAS_DISK",   "HAS_RECTANGLE",     "HAS_TRIANGLE"};
    constexpr std::array variants = {"HAS_TEXTBOOK", "HAS_ROBUST", "HAS_COMPENSATED", "HAS_CURVATURE"};
    std::set<std::string> features{kinds.at(static_cast<std::size_t>(primitive)),
                                   variants.at(static_cast<std::size_t>(variant))};
    if (primitive == shapeOpenCylinder || primitive == shapeCappedCylinder)
        features.insert("HAS_CYLINDER");
    if (primitive >= shapePlane)
        features.insert("HAS_FLAT");
    return features;
}

// Those of one kind by one variant, `places` in the whole.
void runGroup(const KernelDevice& device, std::span<const RayProblem> problems, int primitive,
              Variant variant, Frame frame, const std::vector<std::size_t>& places,
              std::vector<DeviceAnswer>& answers)
{
    std::vector<RayProblem> group;
    for (const std::size_t place : places)
        group.push_back(problems[place]);
    const KernelRows rows = kernelRows(group, variant, frame);
    const auto given = runTable(device.glslFolder, "stability/shapes", featuresOf(primitive, variant),
                                device.guard, rows.table, 2);
    for (std::size_t i = 0; i < places.size(); ++i) {
        DeviceAnswer& answer = answers[places[i]];
        answer.hit = given[2 * i].x > 0.5F;
        answer.t = static_cast<double>(given[2 * i].y) * rows.lengthOfT[i];
        answer.normal = glm::dvec3(given[2 * i + 1].x, given[2 * i + 1].y, given[2 * i + 1].z);
    }
}

} // namespace

std::vector<DeviceAnswer> runKernels(const KernelDevice& device, std::span<const RayProblem> problems,
                                     std::optional<Variant> variant, Frame frame)
{
    std::map<std::pair<int, Variant>, std::vector<std::size_t>> groups;
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const RayProblem& problem = problems[i];
        if (problem.primitive < shapeSphere || problem.primitive > shapeTriangle)
            continue;
        const glm::dvec3 frameOrigin = frame == Frame::ofRay ? problem.origin : glm::dvec3(0.0);
        const Variant wanted = variant.value_or(strictestFor(problem, frameOrigin));
        const Variant chosen = isFor(wanted, problem.primitive) ? wanted : Variant::compensated;
        groups[{problem.primitive, chosen}].push_back(i);
    }
    std::vector<DeviceAnswer> answers(problems.size());
    for (const auto& [key, places] : groups)
        runGroup(device, problems, key.first, key.second, frame, places, answers);
    return answers;
}

} // namespace dioptre
