// An independent GLSL compiler.
#pragma once

#include <map>
#include <string>

namespace dioptre::test
{

// What glslangValidator says of shaders: nothing where it accepts them all. By the files' names, which end in
// .frag or .vert.
std::string complaints(const std::map<std::string, std::string>& shaders);

} // namespace dioptre::test
