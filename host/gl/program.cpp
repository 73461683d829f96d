#include "gl/program.h"

#include <array>
#include <cstddef>

namespace dioptre
{
namespace
{

// The log of a shader or program, read with the pair of functions that belongs to its kind.
template <typename GetParameter, typename GetLog>
[[noreturn]] void throwLog(GLuint name, GetParameter getParameter, GetLog getLog, bool inVertexStage = false)
{
    GLint size = 0;
    getParameter(name, GL_INFO_LOG_LENGTH, &size);
    std::string log(static_cast<std::size_t>(size), '\0');
    GLsizei written = 0;
    getLog(name, size, &written, log.data());
    log.resize(static_cast<std::size_t>(written));
    ShaderError error{parseLog(log), inVertexStage};
    if (error.messages.empty())
        error.messages.emplace_back().text = "error: the driver refuses the shader and does not say why";
    throw error;
}

Shader compile(GLenum stage, const std::string& text)
{
    Shader shader(glCreateShader(stage));
    const char* const start = text.data();
    const auto length = static_cast<GLint>(text.size());
    glShaderSource(shader.name(), 1, &start, &length);
    glCompileShader(shader.name());
    GLint compiled = GL_FALSE;
    glGetShaderiv(shader.name(), GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE)
        throwLog(shader.name(), glGetShaderiv, glGetShaderInfoLog, stage == GL_VERTEX_SHADER);
    return shader;
}

GLint parameter(GLuint program, GLenum which)
{
    GLint value = 0;
    glGetProgramiv(program, which, &value);
    return value;
}

// Names as they stand in the shader: OpenGL reports the array u_x as "u_x[0]".
std::vector<ActiveUniform> activeUniforms(GLuint program)
{
    std::vector<ActiveUniform> uniforms;
    std::string buffer(static_cast<std::size_t>(parameter(program, GL_ACTIVE_UNIFORM_MAX_LENGTH)) + 1, '\0');
    const auto count = static_cast<GLuint>(parameter(program, GL_ACTIVE_UNIFORMS));
    for (GLuint index = 0; index < count; ++index) {
        GLsizei length = 0;
        ActiveUniform uniform;
        glGetActiveUniform(program, index, static_cast<GLsizei>(buffer.size()), &length, &uniform.elements,
                           &uniform.type, buffer.data());
        uniform.name.assign(buffer, 0, static_cast<std::size_t>(length));
        uniform.location = glGetUniformLocation(program, uniform.name.c_str());
        if (uniform.location < 0) // inside a block, or built in
            continue;
        if (uniform.name.ends_with("[0]"))
            uniform.name.resize(uniform.name.size() - 3);
        uniforms.push_back(std::move(uniform));
    }
    return uniforms;
}

std::map<std::string, GLuint> activeBlocks(GLuint program)
{
    std::map<std::string, GLuint> blocks;
    std::string buffer(
        static_cast<std::size_t>(parameter(program, GL_ACTIVE_UNIFORM_BLOCK_MAX_NAME_LENGTH)) + 1, '\0');
    const auto count = static_cast<GLuint>(parameter(program, GL_ACTIVE_UNIFORM_BLOCKS));
    for (GLuint index = 0; index < count; ++index) {
        GLsizei length = 0;
        glGetActiveUniformBlockName(program, index, static_cast<GLsizei>(buffer.size()), &length,
                                    buffer.data());
        blocks[buffer.substr(0, static_cast<std::size_t>(length))] = index;
    }
    return blocks;
}

} // namespace

Program buildProgram(const std::string& fragmentText, const std::string& vertexText)
{
    const Shader vertex = compile(GL_VERTEX_SHADER, vertexText);
    const Shader fragment = compile(GL_FRAGMENT_SHADER, fragmentText);
    ProgramName name(glCreateProgram());
    glAttachShader(name.name(), vertex.name());
    glAttachShader(name.name(), fragment.name());
    glLinkProgram(name.name());
    glDetachShader(name.name(), vertex.name());
    glDetachShader(name.name(), fragment.name());
    if (parameter(name.name(), GL_LINK_STATUS) == GL_FALSE)
        throwLog(name.name(), glGetProgramiv, glGetProgramInfoLog);
    std::map<std::string, GLint> uniforms;
    for (const auto& uniform : activeUniforms(name.name()))
        uniforms[uniform.name] = uniform.location;
    auto blocks = activeBlocks(name.name());
    return {std::move(name), std::move(uniforms), std::move(blocks)};
}

std::vector<ActiveUniform> activeUniformsOf(const Program& program)
{
    return activeUniforms(program.name.name());
}

// Vertices 0, 1, 2 at (-1, -1), (3, -1), (-1, 3): the viewport is the corner square of that triangle, so no
// diagonal seam.
std::string fullScreenMain(const std::string& statements)
{
    return R"(void main()
{
    vec2 corner = vec2(float((gl_VertexID << 1) & 2), float(gl_VertexID & 2));
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
)" + statements +
           "}\n";
}

} // namespace dioptre
