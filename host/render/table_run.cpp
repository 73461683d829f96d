#include "render/table_run.h"

#include "gl/texture.h"
#include "render/device_scene.h"
#include "render/probe.h"

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr std::size_t side = 512; // rows to a line of pixels, and lines to a draw

// Rows first..first + count as a picture: line after line, the next texel of all rows above.
Picture pictureOf(const DeviceTable& table, std::size_t first, std::size_t count, std::size_t lines)
{
    Picture picture = blankFloats(static_cast<int>(side), static_cast<int>(lines * table.texels));
    for (std::size_t row = 0; row < count; ++row)
        for (std::size_t texel = 0; texel < table.texels; ++texel) {
            const glm::dvec4& from = table.numbers[(first + row) * table.texels + texel];
            float* const to = &picture.floats[4 * (texel * lines * side + row)];
            for (int c = 0; c < 4; ++c)
                to[c] = static_cast<float>(from[c]);
        }
    return picture;
}

void addGuard(std::set<std::string>& features, Guard guard)
{
    if (guard == Guard::precise)
        features.insert("HAS_PRECISE");
    if (guard == Guard::unit)
        features.insert("HAS_UNIT");
}

} // namespace

std::vector<glm::vec4> runTable(const std::filesystem::path& glslFolder, const std::string& name,
                                std::set<std::string> features, Guard guard, const DeviceTable& table,
                                int parts)
{
    addGuard(features, guard);
    const Program program = useProbe(glslFolder, name, features);
    const auto width = static_cast<std::size_t>(parts);
    std::vector<glm::vec4> answers(table.rows() * width);
    for (std::size_t first = 0; first < table.rows(); first += side * side) {
        const std::size_t count = std::min(side * side, table.rows() - first);
        const std::size_t lines = (count + side - 1) / side;
        const Texture texture = uploadTable(pictureOf(table, first, count, lines));
        glActiveTexture(GL_TEXTURE0);
        glBindTexture(GL_TEXTURE_2D, texture.name());
        glUniform1i(locationOf(program, "u_rows"), 0);
        glUniform1i(locationOf(program, "u_height"), static_cast<int>(lines));
        glUniform1f(locationOf(program, "u_one"), 1.0F);
        for (int part = 0; part < parts; ++part) {
            glUniform1i(locationOf(program, "u_part"), part);
            const Picture drawn = drawProbe(static_cast<int>(side), static_cast<int>(lines));
            for (std::size_t row = 0; row < count; ++row) {
                const float* const from = &drawn.floats[4 * row];
                answers[(first + row) * width + static_cast<std::size_t>(part)] = {from[0], from[1], from[2],
                                                                                   from[3]};
            }
        }
    }
    return answers;
}

} // namespace dioptre
