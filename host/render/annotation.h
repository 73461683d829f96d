// What a shader's author says of a uniform in the comment behind it: a value to start with, a range, a label.
//     uniform float u_roughness; // 0.3 [0.02, 1.0] microfacet roughness
//     uniform vec3 u_tint;       // #ff8800 colour
//     uniform vec2 u_shift;      // [1, 0.5] [0, 2]
//     uniform bool u_on;         // true
#pragma once

#include "render/source_text.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// A value's place in a line.
struct ValueColumns {
    int first = 0; // from 1, in bytes
    int count = 0;
};

// A uniform that a slider may set: one of bool, int, uint, float or a vector of them, and no array.
struct Annotation {
    std::string name;
    std::string type;             // "vec3"
    std::vector<double> defaults; // as many as the type has; 0 or 1 of a bool. The declaration's value, else
                                  // the comment's, else 0
    double low = 0.0;             // of each number; where no range is given, one about the defaults
    double high = 1.0;
    std::string label;                     // "" where there is none
    SourcePosition where;                  // of the name in its declaration
    std::optional<ValueColumns> inComment; // the value there; all on the line of `where`
    std::optional<ValueColumns>
        inDeclaration; // "2.0" in "= 2.0;"; none where it is no plain number or vector
};

// By order of declaration. A comment that does not begin with a value is none, and so is a number without a
// range behind a vector, or that is none of its type. Throws badInput at a value of the wrong count or type,
// a range that is not two numbers, the lower first, and a default outside it.
std::vector<Annotation> annotationsOf(const SourceText& source);

// The text of a file with new values, by name, in the comments and in the declarations that give one, every
// other byte as it was. Names without such a place are left out. Values must be as many as the type has and
// within the range, or annotationsOf() refuses the result. Throws as annotationsOf().
std::string withDefaults(const std::string& fileText,
                         const std::map<std::string, std::vector<double>>& values);

} // namespace dioptre
