// A plain shader from its file to a picture: one sample a pixel, no decoding and no encoding.
#pragma once

#include "gl/context.h"
#include "render/drawing.h"
#include "render/plain_channels.h"
#include "render/plain_uniforms.h"
#include "render/prepare.h"

namespace dioptre
{

struct PlainSettings {
    std::array<ChannelSource, 4> channels;
    PlainFrame frame;
    PlainValues values;                          // of --set
    std::vector<std::filesystem::path> included; // folders of --include
};

// Before the context is made: uninitialised variables start as 0 on drivers that can (Mesa's), as in a
// browser.
void startVariablesAtZero();

class PlainRenderer final : public Drawing
{
public:
    // On the current context. Throws badInput with the author's file and line when the shader does not
    // compile or reads what nothing feeds, and usage for values that do not fit it.
    PlainRenderer(const std::filesystem::path& shader, const ViewSettings& view, PlainSettings plain,
                  const ContextInfo& context);

    // Goes on at another time.
    void moveTo(const PlainFrame& frame);

    // Colours as the shader gives them. Throws badInput where the driver ended loops of the shader, and the
    // picture is not what the shader says.
    PixelCounts finish(Picture& picture) const override;

    DrawingFacts facts() const override;

    const SourceText& text() const
    {
        return text_.text;
    }

protected:
    void drawRegion() override;
    long passes() const override;

private:
    void build(PlainForm form, const SearchPlaces& places);
    HostNumbers numbers() const; // of the frame
    void bind() const;           // program, channels and what the frame feeds

    std::filesystem::path shader_;
    PlainSettings plain_;
    glm::ivec2 size_px_; // of the whole picture
    PlainText text_;
    std::array<Channel, 4> channels_;
    Program program_;
    std::vector<HostUniform> uniforms_; // that each frame feeds
};

} // namespace dioptre
