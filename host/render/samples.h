// How the samples of a picture are dealt out to draws.
#pragma once

#include "render/plan.h"

namespace dioptre
{

struct SampleBatch {
    int first = 0; // index of the first sample
    int count = 0;
};

// The most loop iterations that one sample can take in this shader.
long loopIterations(const Plan& plan, const PackedScene& packed);

// Batches of consecutive samples, each within the loop iterations that a driver runs: llvmpipe ends every
// loop silently after 65,535 in all. Depends on the settings alone, so that tiles add up bit for bit. Throws
// badInput where a single sample would go beyond on a software driver.
std::vector<SampleBatch> sampleBatches(int samples, long iterationsPerSample, bool software);

} // namespace dioptre
