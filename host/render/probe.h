// The small shaders of glsl/probe/, which measure what the current context's device does.
#pragma once

#include "gl/program.h"
#include "gl/target.h"
#include "render/source_text.h"

#include <filesystem>
#include <set>
#include <string>

namespace dioptre
{

// glsl/NAME.frag, "probe/add" for one, with the given HAS_ features. Throws badInput, inputMissing.
SourceText probeText(const std::filesystem::path& glslFolder, const std::string& name,
                     const std::set<std::string>& features = {});

// Builds it and makes it current.
Program useProbe(const std::filesystem::path& glslFolder, const std::string& name,
                 const std::set<std::string>& features = {});

// What the current program writes into a target of that size, unblended; rows from the bottom up.
Picture drawProbe(int width, int height);

// How three draws that add up in a float32 target come out.
struct FloatSums {
    bool right = false;     // within two units in the last place
    double worst_ulp = 0.0; // of the four channels, against sums made by the host
};
FloatSums probeFloatSums(const std::filesystem::path& glslFolder);

// One draw of tens of milliseconds on a CPU by both clocks of a FrameClock; the least of three.
struct Clocks {
    double finish_ms = 0.0;
    double timerQuery_ms = 0.0;

    // Whether timer queries tell at least half of the time that passed.
    bool queriesHold() const
    {
        return timerQuery_ms >= 0.5 * finish_ms;
    }
};
Clocks probeClocks(const std::filesystem::path& glslFolder);

} // namespace dioptre
