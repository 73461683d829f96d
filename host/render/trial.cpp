#include "render/trial.h"

#include "base/clock.h"
#include "gl/target.h"
#include "gl/uniform.h"
#include "gl/wait.h"
#include "render/annotation.h"
#include "render/device_scene.h"
#include "render/number_list.h"
#include "render/still.h"

#include <algorithm>
#include <numeric>

namespace dioptre
{
namespace
{

// The first draw may take its time: drivers compile in it.
constexpr double compileLimit_s = 3600.0;

Program build(const ProgramTrial& trial)
{
    return trial.vertex.empty() ? buildProgram(trial.fragment) : buildProgram(trial.fragment, trial.vertex);
}

// Uniforms by their active types; what is not named stays as the shader has it.
void feed(const Program& program, const ProgramTrial& trial)
{
    for (const auto& uniform : activeUniformsOf(program)) {
        const UniformType* type = uniformType(uniform.type);
        const auto found = trial.uniforms.find(uniform.name);
        if (type == nullptr || type->numbers == UniformType::Numbers::sampler ||
            found == trial.uniforms.end())
            continue;
        auto numbers = found->second;
        numbers.resize(numbersOf(*type, uniform), 0.0);
        for (double& number : numbers)
            number = fits(*type, number) ? number : 0.0;
        setUniform(*type, uniform, numbers);
    }
}

std::vector<Buffer> bindBlocks(const Program& program, const ProgramTrial& trial)
{
    std::vector<Buffer> buffers;
    for (const auto& [name, index] : program.uniformBlocks)
        if (const auto found = trial.blocks.find(name); found != trial.blocks.end()) {
            const auto binding = static_cast<GLuint>(buffers.size());
            buffers.push_back(uploadUniformBuffer(found->second));
            glUniformBlockBinding(program.name.name(), index, binding);
            glBindBufferBase(GL_UNIFORM_BUFFER, binding, buffers.back().name());
        }
    return buffers;
}

std::vector<Texture> bindTextures(const Program& program, const ProgramTrial& trial)
{
    std::vector<Texture> textures;
    for (const auto& [name, shape] : trial.textures)
        if (const auto found = program.uniforms.find(name); found != program.uniforms.end()) {
            const auto unit = static_cast<GLint>(textures.size());
            textures.push_back(makeTexture(shape));
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(shape.target, textures.back().name());
            glUniform1i(found->second, unit);
        }
    return textures;
}

// The corners on the device, where a trial has some.
struct TrialCorners {
    VertexArray vertexArray;
    Buffer buffer;
    GLsizei count = 0;
};

TrialCorners uploadCorners(const std::vector<float>& numbers)
{
    TrialCorners corners;
    if (numbers.empty())
        return corners;
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    corners.vertexArray = VertexArray(name);
    glBindVertexArray(name);
    glGenBuffers(1, &name);
    corners.buffer = Buffer(name);
    glBindBuffer(GL_ARRAY_BUFFER, name);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(numbers.size() * sizeof(float)), numbers.data(),
                 GL_STATIC_DRAW);
    const int each = std::accumulate(cornerSizes.begin(), cornerSizes.end(), 0);
    std::size_t offset = 0;
    for (GLuint location = 0; location < cornerSizes.size(); ++location) {
        glEnableVertexAttribArray(location);
        glVertexAttribPointer(location, cornerSizes[location], GL_FLOAT, GL_FALSE,
                              each * static_cast<GLsizei>(sizeof(float)),
                              reinterpret_cast<const void*>(offset)); // NOLINT: OpenGL takes offsets so
        offset += static_cast<std::size_t>(cornerSizes[location]) * sizeof(float);
    }
    corners.count = static_cast<GLsizei>(numbers.size()) / each;
    return corners;
}

// Into so many pixels from the lower left.
void drawTrial(const TrialCorners& corners, const AccumulationTarget& target, int width, int height)
{
    if (corners.count == 0)
        return drawAdding(target, 0, 0, width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glViewport(0, 0, target.width, target.height);
    glBindVertexArray(corners.vertexArray.name());
    glDrawArrays(GL_TRIANGLES, 0, corners.count);
}

void setSampleCount(const Program& program, int count)
{
    if (const auto found = program.uniforms.find("u_sample_count"); found != program.uniforms.end())
        glUniform1i(found->second, count);
}

void lookAt(const Picture& picture, TrialOutcome& outcome)
{
    outcome.endedLoops = countEndedLoops(picture);
    const auto& numbers = picture.floats;
    for (std::size_t i = 0; i < numbers.size(); ++i)
        outcome.mean[i % 4] += 4.0 * static_cast<double>(numbers[i]) / static_cast<double>(numbers.size());
}

} // namespace

ProgramTrial trialOf(const AssembledPart& part, const PackedScene& packed)
{
    ProgramTrial trial{flatten(part.shader), flatten(part.vertex), {}, {}, {}};
    for (const auto& block : plannedBlocks(part.plan))
        trial.blocks[block] = blockValues(block, packed);
    trial.uniforms = fixedUniforms(packed, trialSize_px, {0, 0});
    trial.textures = textureShapes(part.plan, packed);
    return trial;
}

ProgramTrial trialOf(const LoadedPlain& loaded, const PlainSettings& plain)
{
    ProgramTrial trial{flatten(loaded.text.text), "", {}, {}, {}};
    trial.marksEndedLoops = loaded.text.checksLoops;
    std::array<glm::ivec2, 4> sizes_px;
    std::ranges::transform(loaded.channels, sizes_px.begin(), &ChannelPictures::size_px);
    trial.uniforms = frameNumbers(plain.frame, trialSize_px, {0, 0}, sizes_px);
    for (const auto& [name, value] : plain.values)
        if (const auto numbers = numbersIn(value))
            trial.uniforms[name] = *numbers;
    for (const auto& annotation : annotationsOf(loaded.text.text))
        trial.uniforms.emplace(annotation.name, annotation.defaults);
    for (std::size_t i = 0; i < loaded.channels.size(); ++i)
        trial.textures.emplace_back("iChannel" + std::to_string(i), loaded.channels[i].shape);
    return trial;
}

TrialOutcome tryProgram(const ProgramTrial& trial, double drawLimit_s)
{
    TrialOutcome outcome;
    Stopwatch watch;
    Program program;
    try {
        program = build(trial);
    } catch (const ShaderError& error) {
        return {error.messages, error.inVertexStage};
    }
    outcome.compile_ms = watch.lap_ms();
    const AccumulationTarget target = makeAccumulationTarget(trialSize_px.x, trialSize_px.y);
    glUseProgram(program.name.name());
    feed(program, trial);
    const auto buffers = bindBlocks(program, trial);
    const auto textures = bindTextures(program, trial);
    const TrialCorners corners = uploadCorners(trial.corners);
    setSampleCount(program, 0);
    watch.lap_ms();
    drawTrial(corners, target, 1, 1);
    waitForDevice(compileLimit_s);
    outcome.firstDraw_ms = watch.lap_ms();
    clear(target);
    setSampleCount(program, 1);
    drawTrial(corners, target, target.width, target.height);
    waitForDevice(drawLimit_s);
    lookAt(readBack(target), outcome);
    return outcome;
}

} // namespace dioptre
