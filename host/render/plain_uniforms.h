// The uniforms of a plain shader: Shadertoy's, those of The Book of Shaders, and any other by --set.
#pragma once

#include "gl/program.h"
#include "gl/uniform.h"
#include "render/plain_text.h"
#include "render/pointer.h"
#include "scene/scene.h"

#include <glm/glm.hpp>

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// A day as Shadertoy counts it.
struct CalendarDate {
    int year = 0;
    int month = 0; // 0 to 11
    int day = 0;   // 1 to 31
    double sinceMidnight_s = 0.0;
};

// What a live host moves in the shaders that read it. Where one is unset, the shader's own value holds, by
// its declaration or the comment behind it; else what is named here.
struct LiveValues {
    std::optional<LightType> lightType;  // u_light_type: lit
    std::optional<double> lightHeight_m; // u_light_height: 3
    std::optional<Camera> camera;        // u_camera_position, u_camera_target, u_fov_y_deg: as Camera says
    std::map<std::string, std::vector<double>> sliders; // any other uniform, by name
};

// What a frame of a plain shader is told beside the picture's size.
struct PlainFrame {
    double time_s = 0.0;
    double rate = 60.0; // frames a second
    Pointer pointer;
    std::optional<CalendarDate> date; // none: 1 January 2026, time_s seconds after midnight
    LiveValues live;                  // one that is no longer set stays as it was
};

// NAME=value of --set, by name.
using PlainValues = std::map<std::string, std::string>;

// A uniform's numbers by name: as many as its type wants, or more, or fewer (then the rest is 0).
using HostNumbers = std::map<std::string, std::vector<double>>;

HostNumbers hostUniforms(const PlainFrame& frame, int width, int height,
                         const std::array<glm::ivec2, 4>& channelSizes_px);

// What a live host's sliders and keys begin at: every uniform of the text that may have a slider and that
// nothing else feeds, with the shader's own value, or that of a live host at rest. Throws as annotationsOf().
HostNumbers sliderStarts(const SourceText& text);

// One that a program reads and each frame may feed.
struct HostUniform {
    ActiveUniform uniform;
    const UniformType* type;
};

// Sets what stays the same for all frames of the program, which must be current: samplers, named iChannel0 to
// 3, to the units 0 to 3, and `values`. Gives the others. Of these, any that `host` has no numbers for starts
// with a value of its own, by its declaration or its annotation, both found in `text`, or at LiveValues'
// rest. Throws badInput for a uniform that nothing feeds and for a faulty annotation, usage for a value that
// does not fit its type and for one of `values` that the shader does not read.
std::vector<HostUniform> feedOnce(const Program& program, const HostNumbers& host, const PlainValues& values,
                                  const std::filesystem::path& shader, const SourceText& text);

// Sets those that `host` has numbers for, of the program that is current. Throws badInput where a number is
// none of its uniform's type.
void feedFrame(const std::vector<HostUniform>& uniforms, const HostNumbers& host,
               const std::filesystem::path& shader);

} // namespace dioptre
