// Bad input ends with a message that names the place and the mend, the right exit code, and no picture: the
// rows of one table, told apart by what they are about.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace dioptre::test
{

struct Case {
    std::string name;
    std::string setUp;   // shell commands, in an empty folder
    std::string command; // what the user types
    int code;
    std::vector<std::string> says; // on standard error
};

void PrintTo(const Case& refused, std::ostream* stream);

// A row of the table; refusal_test.cpp says what must hold of each.
class Refusal : public testing::TestWithParam<Case>
{
};

inline std::string nameOf(const testing::TestParamInfo<Case>& info)
{
    return info.param.name;
}

// A scene file of the given text.
inline std::string scene(const std::string& text)
{
    return "printf '" + text + "' >bad.toml";
}

// p.frag in Shadertoy's manner.
inline const std::string plainShader =
    "printf 'void mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(1.0);\n}\n' >p.frag";
inline const std::string small = " --size 16x9 --spp 1 -o a.png";
inline const std::string renderBad = "dioptre render bad.toml" + small;

} // namespace dioptre::test
