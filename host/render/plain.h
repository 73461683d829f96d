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

// A plain shader before there is a device.
struct LoadedPlain {
    std::filesystem::path shader;
    SearchPlaces places; // of its includes
    PlainForm form;
    PlainText text;
    std::array<ChannelPictures, 4> channels;
    double load_ms = 0.0; // what the loading took
};

// `software`: what of ContextInfo the text hangs on. Throws badInput and inputMissing.
LoadedPlain loadPlain(const std::filesystem::path& shader, const ViewSettings& view,
                      const PlainSettings& plain, bool software);

// The same without the check that tells where a driver ended loops, whose text may fail where the shader's
// own would not: it is not looked at as closely as a compiler does.
void leaveOutLoopCheck(LoadedPlain& loaded);

// What a frame feeds a shader in a picture of so many pixels, by uniform.
HostNumbers frameNumbers(const PlainFrame& frame, const glm::ivec2& size_px, const glm::ivec2& origin_px,
                         const std::array<glm::ivec2, 4>& channelSizes_px);

// Before the context is made: uninitialised variables start as 0 on drivers that can (Mesa's), as in a
// browser.
void startVariablesAtZero();

// Pixels that say that a driver ended their loops, see PlainText.
std::size_t countEndedLoops(const Picture& picture);

// Throws badInput: in so many pixels.
[[noreturn]] void failForEndedLoops(const std::filesystem::path& shader, std::size_t pixels);

class PlainRenderer final : public Drawing
{
public:
    // On the current context. Throws badInput with the author's file and line when the shader does not
    // compile or reads what nothing feeds, and usage for values that do not fit it.
    PlainRenderer(const std::filesystem::path& shader, const ViewSettings& view, PlainSettings plain,
                  const ContextInfo& context);

    // The same of what was loaded before.
    PlainRenderer(LoadedPlain loaded, const ViewSettings& view, PlainSettings plain);

    // Goes on at another time.
    void moveTo(const PlainFrame& frame);

    // Goes on with other values of --set. Throws as the constructor does.
    void update(PlainValues values);

    // Goes on in a picture of another size; with other pictures of the same kinds.
    void update(const glm::ivec2& size_px);
    void update(const std::array<ChannelPictures, 4>& channels);

    // Colours as the shader gives them. Throws badInput where the driver ended loops of the shader, and the
    // picture is not what the shader says.
    PixelCounts finish(Picture& picture) const override;

    DrawingFacts facts() const override;

    const SourceText& text() const
    {
        return loaded_.text.text;
    }

protected:
    void drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area) override;
    std::span<const SampleBatch> batches() const override;

private:
    void build();
    HostNumbers numbers() const; // of the frame
    void bind() const;           // program, channels and what the frame feeds

    LoadedPlain loaded_; // its pictures are on the device
    PlainSettings plain_;
    glm::ivec2 size_px_; // of the whole picture
    std::array<Channel, 4> channels_;
    Program program_;
    std::vector<HostUniform> uniforms_; // that each frame feeds
};

} // namespace dioptre
