#include "render/probe.h"

#include "base/file.h"
#include "render/build.h"
#include "render/device_scene.h"
#include "render/frame_clock.h"
#include "render/preprocess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace dioptre
{

SourceText probeText(const std::filesystem::path& glslFolder, const std::string& name,
                     const std::set<std::string>& features)
{
    PreprocessInput input;
    input.search.folders = {glslFolder};
    input.features = features;
    const std::string include = "#include \"" + name + ".frag\"";
    return preprocess(linesOf("#version 330 core\n" + include, "generated"), input);
}

Program useProbe(const std::filesystem::path& glslFolder, const std::string& name,
                 const std::set<std::string>& features)
{
    Program program = buildProgram(probeText(glslFolder, name, features));
    glUseProgram(program.name.name());
    return program;
}

Picture drawProbe(int width, int height)
{
    const auto target = makeAccumulationTarget(width, height);
    drawReplacing(target);
    return readBack(target);
}

FloatSums probeFloatSums(const std::filesystem::path& glslFolder)
{
    // Numbers that half floats cannot hold, of both signs, and sums that round.
    constexpr std::array<std::array<float, 4>, 3> addends{{{0.1F, 65521.5F, -3.0e-7F, 1.0F},
                                                           {0.7F, 1.0e6F, 1.0e-9F, 6.0e-8F},
                                                           {-0.3F, 1.0e8F, 2.0e-3F, 6.0e-8F}}};
    const Program program = useProbe(glslFolder, "probe/add");
    const auto target = makeAccumulationTarget(1, 1);
    std::array<double, 4> sums{};
    for (const auto& addend : addends) {
        glUniform4fv(locationOf(program, "u_addend"), 1, addend.data());
        drawAdding(target, 0, 0, 1, 1);
        for (std::size_t c = 0; c < 4; ++c)
            sums[c] = static_cast<double>(static_cast<float>(sums[c] + static_cast<double>(addend[c])));
    }
    const Picture picture = readBack(target);
    FloatSums result;
    for (std::size_t c = 0; c < 4; ++c) {
        const double ulp = std::abs(sums[c]) * static_cast<double>(std::numeric_limits<float>::epsilon());
        result.worst_ulp =
            std::max(result.worst_ulp, std::abs(static_cast<double>(picture.floats[c]) - sums[c]) / ulp);
    }
    result.right = result.worst_ulp <= 2.0;
    return result;
}

Clocks probeClocks(const std::filesystem::path& glslFolder)
{
    const Program program = useProbe(glslFolder, "probe/loops");
    glUniform2i(locationOf(program, "u_limits"), 500, 0);
    // llvmpipe's query tells of the last tiles of 64x64 pixels alone, so that one tile would hide its lie.
    const auto target = makeAccumulationTarget(512, 512);
    const auto draw = [&target] { drawReplacing(target); };
    draw(); // drivers compile at the first draw
    const auto leastBy = [&draw](ClockKind kind) {
        FrameClock clock(kind);
        return std::min({clock.time_ms(draw), clock.time_ms(draw), clock.time_ms(draw)});
    };
    return {leastBy(ClockKind::finish), leastBy(ClockKind::timerQuery)};
}

} // namespace dioptre
