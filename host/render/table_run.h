// A shader run over a table of numbers on the current context: a row a pixel.
#pragma once

#include "render/exact_arithmetic.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <filesystem>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace dioptre
{

// Rows of vec4; the device gets them rounded to float.
struct DeviceTable {
    std::size_t texels = 1;          // of a row
    std::vector<glm::dvec4> numbers; // row after row
    std::size_t rows() const
    {
        return numbers.size() / texels;
    }
};

// Runs glsl/NAME.frag with HAS_ features over all rows and gives `parts` vec4 a row, row after row. The
// shader reads u_rows and u_height as glsl/stability/shapes.frag does and writes part u_part. Compensated
// arithmetic is guarded in the given way. Throws badInput, inputMissing.
std::vector<glm::vec4> runTable(const std::filesystem::path& glslFolder, const std::string& name,
                                std::set<std::string> features, Guard guard, const DeviceTable& table,
                                int parts);

} // namespace dioptre
