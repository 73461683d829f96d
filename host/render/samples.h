// How the samples of a picture are dealt out to draws.
#pragma once

#include "render/plan.h"

namespace dioptre
{

// llvmpipe ends every loop of an invocation silently after so many iterations in all; `dioptre doctor`
// measures it.
inline constexpr long softwareLoopCap = 65535;

// The most that a draw of several samples may take, on every driver, so that the order of additions is the
// same. Half the cap, for drivers that count otherwise.
inline constexpr long iterationsPerDraw = softwareLoopCap / 2;

struct SampleBatch {
    int first = 0; // index of the first sample
    int count = 0;
};

// The most loop iterations that one sample can take in this shader.
long loopIterations(const Plan& plan, const PackedScene& packed);

// Batches of consecutive samples, each within iterationsPerDraw where more than one sample is in it. Depends
// on the settings alone, so that tiles add up bit for bit. Throws badInput where a single sample would go
// beyond softwareLoopCap on a software driver.
std::vector<SampleBatch> sampleBatches(int samples, long iterationsPerSample, bool software);

} // namespace dioptre
