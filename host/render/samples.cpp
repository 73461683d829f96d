#include "render/samples.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

long loopIterations(const Plan& plan, const PackedScene& packed)
{
    const long lights = static_cast<long>(packed.lights.size());
    const long objects = static_cast<long>(packed.objects.size());
    const long pool = plan.tree == RayTree::heaviestFirst ? 2 * packed.poolSlots : 0;
    const bool loops = plan.form == SceneForm::loop;
    const long hit = loops ? objects + packed::KIND_COUNT : 0;
    const long shadows = plan.has("shadows") && loops ? objects : 0;
    return 1 + plan.budget * (1 + hit + lights * (1 + shadows) + pool);
}

std::vector<SampleBatch> sampleBatches(int samples, long iterationsPerSample, bool software)
{
    if (software && iterationsPerSample > softwareLoopCap)
        fail(ExitCode::badInput,
             fmt::format("a sample may take {} loop iterations, and this software driver ends loops after {}",
                         iterationsPerSample, softwareLoopCap),
             "lower trace.budget, or have fewer lights or, under trace.form = \"loop\", fewer objects");
    const auto fitting = std::max(1L, iterationsPerDraw / iterationsPerSample);
    const int batch = static_cast<int>(std::min<long>(samples, fitting));
    std::vector<SampleBatch> batches;
    for (int first = 0; first < samples; first += batch)
        batches.push_back({first, std::min(batch, samples - first)});
    return batches;
}

} // namespace dioptre
