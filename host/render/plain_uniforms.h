// The uniforms of a plain shader: Shadertoy's, those of The Book of Shaders, and any other by --set.
#pragma once

#include "gl/program.h"
#include "render/plain_text.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// The pointer, in pixels from the lower left corner.
struct Mouse {
    double x_px = 0.0;
    double y_px = 0.0;
    bool down = false; // held since this frame
};

// What a frame of a plain shader is told beside the picture's size.
struct PlainFrame {
    double time_s = 0.0;
    double rate = 60.0;         // frames a second
    std::optional<Mouse> mouse; // none: never touched
};

// NAME=value of --set, by name.
using PlainValues = std::map<std::string, std::string>;

// A uniform's numbers by name: as many as its type wants, or more, or fewer (then the rest is 0).
std::map<std::string, std::vector<double>> hostUniforms(const PlainFrame& frame, int width, int height,
                                                        const std::array<glm::ivec2, 4>& channelSizes_px);

// Sets every active uniform of the program, which must be current: samplers, named iChannel0 to 3, to the
// units 0 to 3. Throws badInput for a uniform that nothing feeds (`text` tells whether it has an initial
// value of its own), usage for a value that does not fit its type and for one of `values` that the shader
// does not read.
void feed(const Program& program, const std::map<std::string, std::vector<double>>& host,
          const PlainValues& values, const std::filesystem::path& shader, const SourceText& text);

} // namespace dioptre
