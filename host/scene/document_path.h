// Paths into a scene's document, as --set and [[animate]] write them: "material.glass.ior",
// "light.0.diffuse", "ball.centre".
#pragma once

#include "scene/document.h"

#include <string>
#include <vector>

namespace dioptre
{

// A path as its author wrote it, and where its faults are reported.
struct DocumentPath {
    std::string text;
    SourcePosition where;
    ExitCode fault; // what a path that leads nowhere ends with
};

// The keys and indices from the root to a value: {"sphere", "0", "centre"} for "ball.centre".
using Steps = std::vector<std::string>;

// Follows a path, a table's or one that starts with an object's name. Its last step may be a key that the
// table has not got yet; a section whose keys all have defaults is created where the file lacks it. Throws
// path.fault, with a "did you mean", for a path that leads nowhere.
Steps resolve(Value& document, const DocumentPath& path);

// Writes the value to where resolve() led; a key that is not there yet is placed at `where`.
void setAt(Value& document, const Steps& steps, const Value& value, const SourcePosition& where);

// Whether one of two paths leads to the other's value or to a part of it.
bool overlap(const Steps& a, const Steps& b);

} // namespace dioptre
