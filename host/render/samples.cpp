#include "render/samples.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// Iterations as llvmpipe counts them. It runs the body of a loop once more with every pixel masked out to
// find that the loop has ended, and the loops within it are each looked at then.
struct Iterations {
    long full = 0;  // at most
    long empty = 0; // where every pixel is masked out
};

Iterations operator+(Iterations a, Iterations b)
{
    return {a.full + b.full, a.empty + b.empty};
}

Iterations loop(long times, Iterations body = {})
{
    return {times * (1 + body.full) + 1 + body.empty, 1 + body.empty};
}

// One loop for each kind of light that there is; the kinds share the lights.
Iterations iterationsOfLights(const Plan& plan, long lights, Iterations shadow)
{
    Iterations all{lights * (1 + shadow.full), 0};
    for (const char* kind : {"HAS_DIRECTIONAL_LIGHT", "HAS_POINT_LIGHT", "HAS_SPOT_LIGHT", "HAS_GLOW"})
        if (plan.defines.contains(kind))
            all = all + loop(0, shadow);
    return all;
}

// What each ray runs: glsl/trace/scene_loop.glsl, light.glsl, and the pool of heaviest_first.glsl.
Iterations iterationsOfARay(const Plan& plan, const PackedScene& packed)
{
    const long objects = static_cast<long>(packed.objects.size());
    Iterations ray;
    if (plan.form == SceneForm::loop)
        ray = loop(packed::KIND_COUNT, loop(0)) + Iterations{objects, 0}; // the kinds share the objects
    if (plan.has("light loops"))
        ray = ray + iterationsOfLights(plan, static_cast<long>(packed.lights.size()),
                                       plan.has("shadows") && plan.form == SceneForm::loop ? loop(objects)
                                                                                           : Iterations{});
    if (plan.tree == RayTree::heaviestFirst)
        ray = ray + loop(packed.poolSlots) + loop(packed.poolSlots);
    return ray;
}

} // namespace

long loopIterations(const Plan& plan, const PackedScene& packed)
{
    Iterations sample = iterationsOfARay(plan, packed);
    if (plan.tree != RayTree::single)
        sample = loop(packed.budget, sample);
    if (plan.tree == RayTree::heaviestFirst)
        sample = sample + loop(packed.poolSlots);
    // What still waits at a sample's end is counted one by one.
    if (showsRayTree(plan.view))
        sample = sample + loop(plan.tree == RayTree::heaviestFirst ? packed.poolSlots : packed.budget);
    return loop(1, sample).full;
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
