#include "render/loop_canary.h"

#include "render/device_scene.h"
#include "render/probe.h"
#include "render/samples.h"

#include <algorithm>
#include <cstdint>

namespace dioptre
{
namespace
{

constexpr long asked = 4 * (softwareLoopCap + 1);
constexpr int neighbours =
    8; // as in loops.frag, and as many as llvmpipe draws side by side with 256-bit vectors

// The generator of loops.frag after so many steps.
std::uint32_t stateAfter(long steps)
{
    std::uint32_t state = 1;
    for (long i = 0; i < steps; ++i)
        state = 1664525U * state + 1013904223U;
    return state;
}

struct Reached {
    std::array<long, 2> least{asked,
                              asked}; // by the pixel that ran least, of the first and of the second loop
    bool faithful = true;
};

Reached run(const Program& program, int pixels, long first, long second)
{
    glUniform2i(locationOf(program, "u_limits"), static_cast<GLint>(first), static_cast<GLint>(second));
    const Picture picture = drawProbe(pixels, 1);
    Reached reached;
    for (std::size_t i = 0; i < picture.floats.size(); i += 4) {
        const std::array<long, 2> ran{static_cast<long>(picture.floats[i]),
                                      static_cast<long>(picture.floats[i + 1])};
        const std::uint32_t state = stateAfter(ran[0] + ran[1]);
        reached.faithful = reached.faithful && picture.floats[i + 2] == static_cast<float>(state >> 16) &&
                           picture.floats[i + 3] == static_cast<float>(state & 0xFFFFU);
        for (std::size_t loop = 0; loop < 2; ++loop)
            reached.least[loop] = std::min(reached.least[loop], ran[loop]);
    }
    return reached;
}

} // namespace

LoopCanary measureLoops(const std::filesystem::path& glslFolder)
{
    Program program = useProbe(glslFolder, "probe/loops");
    const Reached one = run(program, 1, asked, 0);
    LoopCanary canary;
    canary.asked = asked;
    canary.ran = one.least[0];
    canary.askedOfTwo = canary.ran * 3 / 4;
    const Reached two = run(program, 1, canary.askedOfTwo, canary.askedOfTwo);
    canary.ranOfTwo = two.least;
    program = useProbe(glslFolder, "probe/loops", {"HAS_TURNS"});
    canary.askedOfNeighbours = canary.ran * 3 / 4;
    const Reached turns = run(program, neighbours, canary.askedOfNeighbours, 0);
    canary.ranOfNeighbours = turns.least[0];
    canary.faithful = one.faithful && two.faithful && turns.faithful;
    return canary;
}

bool loopsSuffice(const LoopCanary& canary, bool software)
{
    return canary.faithful && (!canary.capped() || (software && canary.ran >= softwareLoopCap));
}

} // namespace dioptre
