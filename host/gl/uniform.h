// Setting uniforms of any type from plain numbers.
#pragma once

#include "gl/program.h"

#include <string_view>
#include <vector>

namespace dioptre
{

// A GLSL type: how many numbers it holds, and how they are handed over.
struct UniformType {
    enum class Numbers { floats, ints, unsigneds, matrix, sampler };
    GLenum type;
    const char* name;
    int components; // of a matrix: its side
    Numbers numbers;
};

// Null for types that are not set this way.
const UniformType* uniformType(GLenum type);
const UniformType* uniformTypeNamed(std::string_view name);

// How many numbers a uniform takes in all, an array's elements included.
std::size_t numbersOf(const UniformType& type, const ActiveUniform& uniform);

// Whether a number can be one of the type's, without rounding to a whole one or running over.
bool fits(const UniformType& type, double value);

// Of the current program; as many numbers as numbersOf() says, each of which fits. Booleans are 0 or not
// 0, matrices run column by column.
void setUniform(const UniformType& type, const ActiveUniform& uniform, const std::vector<double>& values);

} // namespace dioptre
