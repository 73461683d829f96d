// Whether loops are stopped silently, and after how many iterations.
#pragma once

#include <array>
#include <filesystem>

namespace dioptre
{

// Iterations that loops of glsl/probe/loops.frag were asked for, and ran.
struct LoopCanary {
    long asked = 0; // of one loop by itself
    long ran = 0;
    long askedOfTwo = 0; // of each of two loops, one after the other, in one invocation; below the cap
    std::array<long, 2> ranOfTwo{};
    long askedOfNeighbours = 0; // of each of eight neighbouring pixels, which loop in turn; as for two
    long ranOfNeighbours = 0;   // by the one that ran least
    bool faithful = false;      // every count agrees with what the loops computed

    bool capped() const
    {
        return ran < asked;
    }
    bool sharedByLoops() const
    {
        return ranOfTwo[0] < askedOfTwo || ranOfTwo[1] < askedOfTwo;
    }
    bool sharedByNeighbours() const
    {
        return ranOfNeighbours < askedOfNeighbours;
    }
};

// On the current context.
LoopCanary measureLoops(const std::filesystem::path& glslFolder);

// Whether pictures come out whole: draws stay within `softwareLoopCap` (render/samples.h) on software
// drivers, and rely on there being no cap on others.
bool loopsSuffice(const LoopCanary& canary, bool software);

} // namespace dioptre
