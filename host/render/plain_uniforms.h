// The uniforms of a plain shader: Shadertoy's, those of The Book of Shaders, and any other by --set.
#pragma once

#include "gl/program.h"
#include "gl/uniform.h"
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

// The numbers of such a value: "0.5", "true", "[1, 2, 3]", "1,2,3", "#ff8000" (shares of 255, as a shader
// takes them).
std::optional<std::vector<double>> uniformNumbers(std::string text);

// A uniform's numbers by name: as many as its type wants, or more, or fewer (then the rest is 0).
using HostNumbers = std::map<std::string, std::vector<double>>;

HostNumbers hostUniforms(const PlainFrame& frame, int width, int height,
                         const std::array<glm::ivec2, 4>& channelSizes_px);

// One that a program reads and the host feeds for each frame.
struct HostUniform {
    ActiveUniform uniform;
    const UniformType* type;
};

// Sets what stays the same for all frames of the program, which must be current: samplers, named iChannel0 to
// 3, to the units 0 to 3, and `values`. Gives the others, which `host` has names for. Throws badInput for a
// uniform that nothing feeds (`text` tells whether it has an initial value of its own), usage for a value
// that does not fit its type and for one of `values` that the shader does not read.
std::vector<HostUniform> feedOnce(const Program& program, const HostNumbers& host, const PlainValues& values,
                                  const std::filesystem::path& shader, const SourceText& text);

// Sets them, of the program that is current. Throws badInput where a number is none of its uniform's type.
void feedFrame(const std::vector<HostUniform>& uniforms, const HostNumbers& host,
               const std::filesystem::path& shader);

} // namespace dioptre
