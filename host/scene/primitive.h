// The shapes of a scene file: their keys, and how each becomes a Primitive.
#pragma once

#include "scene/scene.h"
#include "scene/table_reader.h"

#include <string>
#include <vector>

namespace dioptre
{

struct PrimitiveKind {
    std::string key;                              // of the array of tables: "sphere"
    std::vector<std::string> required;            // keys of the shape
    std::vector<std::string> optional;            // likewise
    Primitive (*read)(const TableReader& reader); // all required keys are set; throws badInput
};

const std::vector<PrimitiveKind>& primitiveKinds();

} // namespace dioptre
