// The picture as a window shows it: made from what is drawn, and kept while the next is.
#pragma once

#include "base/tone_curve.h"
#include "gl/target.h"
#include "gl/texture.h"
#include "render/build.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <optional>

namespace dioptre
{

class ShownPicture
{
public:
    // On the current context. Throws badInput for faults in glsl/live/.
    explicit ShownPicture(const std::filesystem::path& glslFolder);

    // From sums of so many samples: the bytes that a PNG would hold, but for rounding; without a display
    // those of a picture that is not encoded.
    void take(const AccumulationTarget& sums, int samples, const std::optional<Display>& display);

    // Of two pictures by as many samples: how far they are from each other in each colour, times `scale`,
    // shown as radiance is.
    void takeDifference(const AccumulationTarget& one, const AccumulationTarget& other, int samples,
                        double scale, const std::optional<Display>& display);

    // From numbers of 0 to 1, not encoded.
    void take(const Picture& picture);

    // Draws it into the window of that size, pixel for pixel from the upper left; what it does not cover is
    // black.
    void draw(const glm::ivec2& window_px) const;

    // The same of the columns from that one on alone; those before it stay as they are.
    void drawFrom(int column, const glm::ivec2& window_px) const;

    // 0 before the first.
    const glm::ivec2& size_px() const
    {
        return size_px_;
    }

    // Of 8 bits, rows from the bottom up.
    Picture read() const;

private:
    void makeRoom(const glm::ivec2& size_px);
    void encode(const AccumulationTarget& sums, const AccumulationTarget* other, double scale,
                const std::optional<Display>& display);

    Program program_;
    VertexArray vertexArray_;
    Texture colour_;
    Framebuffer framebuffer_;
    glm::ivec2 size_px_{0};
};

} // namespace dioptre
