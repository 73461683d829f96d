#include "gl/uniform.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace dioptre
{
namespace
{

using Numbers = UniformType::Numbers;

constexpr UniformType uniformTypes[] = {{GL_FLOAT, "float", 1, Numbers::floats},
                                        {GL_FLOAT_VEC2, "vec2", 2, Numbers::floats},
                                        {GL_FLOAT_VEC3, "vec3", 3, Numbers::floats},
                                        {GL_FLOAT_VEC4, "vec4", 4, Numbers::floats},
                                        {GL_INT, "int", 1, Numbers::ints},
                                        {GL_INT_VEC2, "ivec2", 2, Numbers::ints},
                                        {GL_INT_VEC3, "ivec3", 3, Numbers::ints},
                                        {GL_INT_VEC4, "ivec4", 4, Numbers::ints},
                                        {GL_BOOL, "bool", 1, Numbers::ints},
                                        {GL_BOOL_VEC2, "bvec2", 2, Numbers::ints},
                                        {GL_BOOL_VEC3, "bvec3", 3, Numbers::ints},
                                        {GL_BOOL_VEC4, "bvec4", 4, Numbers::ints},
                                        {GL_UNSIGNED_INT, "uint", 1, Numbers::unsigneds},
                                        {GL_UNSIGNED_INT_VEC2, "uvec2", 2, Numbers::unsigneds},
                                        {GL_UNSIGNED_INT_VEC3, "uvec3", 3, Numbers::unsigneds},
                                        {GL_UNSIGNED_INT_VEC4, "uvec4", 4, Numbers::unsigneds},
                                        {GL_FLOAT_MAT2, "mat2", 2, Numbers::matrix},
                                        {GL_FLOAT_MAT3, "mat3", 3, Numbers::matrix},
                                        {GL_FLOAT_MAT4, "mat4", 4, Numbers::matrix},
                                        {GL_SAMPLER_2D, "sampler2D", 1, Numbers::sampler},
                                        {GL_SAMPLER_CUBE, "samplerCube", 1, Numbers::sampler}};

void setFloats(const UniformType& type, const ActiveUniform& uniform, const std::vector<double>& values)
{
    const std::vector<float> v(values.begin(), values.end());
    const GLint at = uniform.location;
    const GLsizei n = uniform.elements;
    if (type.numbers == Numbers::matrix)
        (type.components == 2   ? glUniformMatrix2fv
         : type.components == 3 ? glUniformMatrix3fv
                                : glUniformMatrix4fv)(at, n, GL_FALSE, v.data());
    else
        (type.components == 1   ? glUniform1fv
         : type.components == 2 ? glUniform2fv
         : type.components == 3 ? glUniform3fv
                                : glUniform4fv)(at, n, v.data());
}

void setInts(const UniformType& type, const ActiveUniform& uniform, const std::vector<double>& values)
{
    const GLint at = uniform.location;
    const GLsizei n = uniform.elements;
    if (type.numbers == Numbers::unsigneds) {
        const std::vector<GLuint> v(values.begin(), values.end());
        (type.components == 1   ? glUniform1uiv
         : type.components == 2 ? glUniform2uiv
         : type.components == 3 ? glUniform3uiv
                                : glUniform4uiv)(at, n, v.data());
        return;
    }
    const std::vector<GLint> v(values.begin(), values.end());
    (type.components == 1   ? glUniform1iv
     : type.components == 2 ? glUniform2iv
     : type.components == 3 ? glUniform3iv
                            : glUniform4iv)(at, n, v.data());
}

} // namespace

const UniformType* uniformType(GLenum type)
{
    const auto* found = std::ranges::find(uniformTypes, type, &UniformType::type);
    return found == std::end(uniformTypes) ? nullptr : found;
}

const UniformType* uniformTypeNamed(std::string_view name)
{
    const auto* found = std::ranges::find(uniformTypes, name, &UniformType::name);
    return found == std::end(uniformTypes) ? nullptr : found;
}

std::size_t numbersOf(const UniformType& type, const ActiveUniform& uniform)
{
    const int each = type.numbers == Numbers::matrix ? type.components * type.components : type.components;
    return static_cast<std::size_t>(each) * static_cast<std::size_t>(uniform.elements);
}

bool fits(const UniformType& type, double value)
{
    const bool whole = std::floor(value) == value;
    if (type.name[0] == 'b') // bool, bvec
        return value == 0.0 || value == 1.0;
    switch (type.numbers) {
    case Numbers::ints:
        return whole && std::abs(value) <= 2147483647.0;
    case Numbers::unsigneds:
        return whole && value >= 0.0 && value <= 4294967295.0;
    default:
        return std::abs(value) <= 3.4028234663852886e38;
    }
}

void setUniform(const UniformType& type, const ActiveUniform& uniform, const std::vector<double>& values)
{
    if (type.numbers == Numbers::floats || type.numbers == Numbers::matrix)
        setFloats(type, uniform, values);
    else
        setInts(type, uniform, values);
}

} // namespace dioptre
