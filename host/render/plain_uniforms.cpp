#include "render/plain_uniforms.h"

#include "base/text.h"
#include "gl/uniform.h"
#include "render/annotation.h"
#include "render/number_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

using Numbers = UniformType::Numbers;

std::vector<double> valueFor(const UniformType& type, const ActiveUniform& uniform, const std::string& text)
{
    const auto numbers = numbersIn(text);
    const auto wanted = numbersOf(type, uniform);
    if (!numbers || numbers->size() != wanted ||
        !std::ranges::all_of(*numbers, [&](double number) { return fits(type, number); }))
        fail(ExitCode::usage,
             fmt::format("--set {}={} does not fit the uniform, a {}{}", uniform.name, text, type.name,
                         uniform.elements > 1 ? fmt::format("[{}]", uniform.elements) : ""),
             wanted == 1 ? "give one number"
                         : fmt::format("give {} numbers in brackets, as [0, 1] has 2", wanted));
    return *numbers;
}

// "uniform float u_speed = 2.0;"
bool hasInitialValue(const SourceText& text, const std::string& name)
{
    bool inComment = false;
    for (const auto& line : text) {
        const auto words = identifiers(line.text, inComment);
        const auto declares = std::ranges::find(words, "uniform");
        if (declares == words.end())
            continue;
        const auto found = std::find(declares, words.end(), name);
        if (found == words.end())
            continue;
        const auto after = static_cast<std::size_t>(found->data() - line.text.data()) + name.size();
        const auto next = line.text.find_first_not_of(" \t", after);
        if (next != std::string::npos && line.text[next] == '=')
            return true;
    }
    return false;
}

void refuseUnknown(const PlainValues& values, const std::vector<ActiveUniform>& uniforms,
                   const std::filesystem::path& shader)
{
    std::vector<std::string> names;
    for (const auto& uniform : uniforms)
        names.push_back(uniform.name);
    for (const auto& [name, value] : values) {
        if (std::ranges::find(names, name) != names.end())
            continue;
        const auto nearest = nearestWord(name, names);
        fail(ExitCode::usage,
             fmt::format("--set {}={}: {} reads no uniform of that name", name, value, shader.string()),
             nearest.empty() ? "it reads " + (names.empty() ? "none" : join(names, ", "))
                             : "did you mean '" + nearest + "'?");
    }
}

// Samplers are the channels, in units of the same numbers.
void setChannel(const UniformType& type, const ActiveUniform& uniform, const std::filesystem::path& shader)
{
    const std::string prefix = "iChannel";
    const char last = uniform.name.back();
    if (uniform.name.size() != prefix.size() + 1 || !uniform.name.starts_with(prefix) || last < '0' ||
        last > '3')
        fail(ExitCode::badInput, {shader.string()}, "nothing feeds the sampler " + uniform.name,
             "call it iChannel0 to iChannel3 and give --channel0 FILE");
    setUniform(type, uniform, {static_cast<double>(last - '0')});
}

void setFitting(const HostUniform& fed, std::vector<double> numbers, const std::filesystem::path& shader)
{
    const auto& [uniform, type] = fed;
    numbers.resize(numbersOf(*type, uniform), 0.0);
    for (const double number : numbers)
        if (!fits(*type, number))
            fail(
                ExitCode::badInput, {shader.string()},
                fmt::format("the uniform {} is of type {}, and {} is none", uniform.name, type->name, number),
                "declare it as a float, or as a vector of floats");
    setUniform(*type, uniform, numbers);
}

HostNumbers liveNumbers(const LiveValues& live)
{
    HostNumbers numbers = live.sliders;
    const auto vector = [](const glm::dvec3& v) { return std::vector<double>{v.x, v.y, v.z}; };
    if (live.lightType)
        numbers["u_light_type"] = {static_cast<double>(*live.lightType)};
    if (live.lightHeight_m)
        numbers["u_light_height"] = {*live.lightHeight_m};
    if (live.camera) {
        numbers["u_camera_position"] = vector(live.camera->eye);
        numbers["u_camera_target"] = vector(live.camera->target);
        numbers["u_fov_y_deg"] = {live.camera->fovY_deg};
    }
    return numbers;
}

const HostNumbers& atRest()
{
    static const HostNumbers numbers = liveNumbers(LiveValues{LightType::lit, 3.0, Camera{}, {}});
    return numbers;
}

// What a uniform starts with that neither --set, nor the host, nor its declaration gives: the value in the
// comment behind it, or that of a live host at rest. False where there is neither.
bool setToOwnDefault(const HostUniform& open, const std::vector<Annotation>& annotations,
                     const std::filesystem::path& shader)
{
    const auto annotation = std::ranges::find(annotations, open.uniform.name, &Annotation::name);
    const auto live = atRest().find(open.uniform.name);
    if (annotation != annotations.end() && annotation->inComment)
        setFitting(open, annotation->defaults, shader);
    else if (live != atRest().end())
        setFitting(open, live->second, shader);
    else
        return false;
    return true;
}

} // namespace

HostNumbers hostUniforms(const PlainFrame& frame, int width, int height,
                         const std::array<glm::ivec2, 4>& channelSizes_px)
{
    const double time = frame.time_s;
    const double number = std::clamp(std::floor(time * frame.rate + 0.5), -2147483648.0, 2147483647.0);
    // Equal runs draw equal pictures: the date is always the same day, at as many seconds as the time.
    const CalendarDate day = frame.date.value_or(CalendarDate{2026, 0, 1, time});
    const std::vector<double> date = {static_cast<double>(day.year), static_cast<double>(day.month),
                                      static_cast<double>(day.day), day.sinceMidnight_s};
    std::vector<double> sizes;
    for (const auto& size : channelSizes_px)
        sizes.insert(sizes.end(),
                     {static_cast<double>(size.x), static_cast<double>(size.y), size.x > 0 ? 1.0 : 0.0});
    const std::vector<double> resolution = {static_cast<double>(width), static_cast<double>(height), 1.0};
    const auto mouse = frame.pointer.iMouse();
    HostNumbers numbers = {{"iResolution", resolution},
                           {"iTime", {time}},
                           {"iTimeDelta", {1.0 / frame.rate}},
                           {"iFrameRate", {frame.rate}},
                           {"iFrame", {number}},
                           {"iDate", date},
                           {"iMouse", {mouse.begin(), mouse.end()}},
                           {"iSampleRate", {44100.0}},
                           {"iChannelTime", {time, time, time, time}},
                           {"iChannelResolution", sizes},
                           {"u_resolution", resolution},
                           {"u_time", {time}},
                           {"u_delta", {1.0 / frame.rate}},
                           {"u_frame", {number}},
                           {"u_date", date},
                           {"u_mouse", {frame.pointer.at_px.x, frame.pointer.at_px.y}}};
    numbers.merge(liveNumbers(frame.live));
    return numbers;
}

HostNumbers sliderStarts(const SourceText& text)
{
    const HostNumbers fed = hostUniforms({}, 1, 1, {});
    HostNumbers starts;
    for (const auto& annotation : annotationsOf(text)) {
        const bool told = annotation.inComment || annotation.inDeclaration;
        // One that begins with what only a compiler can read goes on as it begins.
        if (fed.contains(annotation.name) || annotation.where.path == "generated" ||
            (!told && hasInitialValue(text, annotation.name)))
            continue;
        const auto rest = atRest().find(annotation.name);
        if (told || rest != atRest().end())
            starts[annotation.name] = told ? annotation.defaults : rest->second;
    }
    return starts;
}

std::vector<HostUniform> feedOnce(const Program& program, const HostNumbers& host, const PlainValues& values,
                                  const std::filesystem::path& shader, const SourceText& text)
{
    const auto uniforms = activeUniformsOf(program);
    refuseUnknown(values, uniforms, shader);
    const auto annotations = annotationsOf(text);
    std::vector<HostUniform> open;
    for (const auto& uniform : uniforms) {
        const UniformType* type = uniformType(uniform.type);
        if (type == nullptr)
            fail(ExitCode::badInput, {shader.string()},
                 "the uniform " + uniform.name + " is of a type that dioptre does not feed",
                 "use bool, int, uint, float, their vectors, mat2 to mat4, sampler2D, samplerCube");
        const auto value = values.find(uniform.name);
        if (type->numbers == Numbers::sampler)
            setChannel(*type, uniform, shader);
        else if (value != values.end())
            setUniform(*type, uniform, valueFor(*type, uniform, value->second));
        else
            open.push_back({uniform, type});
    }
    for (const auto& [uniform, type] : open)
        if (!host.contains(uniform.name) && !hasInitialValue(text, uniform.name) &&
            !setToOwnDefault({uniform, type}, annotations, shader))
            fail(ExitCode::badInput, {shader.string()}, "nothing feeds the uniform " + uniform.name,
                 fmt::format("give --set {}=VALUE, or a value in its declaration or in a comment behind it",
                             uniform.name));
    return open;
}

void feedFrame(const std::vector<HostUniform>& uniforms, const HostNumbers& host,
               const std::filesystem::path& shader)
{
    for (const auto& fed : uniforms)
        if (const auto numbers = host.find(fed.uniform.name); numbers != host.end())
            setFitting(fed, numbers->second, shader);
}

} // namespace dioptre
