// One input, drawn band by band and at many times: context, programs and pictures are made once.
#pragma once

#include "command/command.h"
#include "command/input.h"
#include "raster/raster_renderer.h"
#include "render/layers.h"
#include "render/plain.h"
#include "render/renderer.h"
#include "render/still.h"
#include "scene/load.h"

#include <memory>
#include <optional>

namespace dioptre
{

class PictureDrawer
{
public:
    // Of a scene everything is made that does not depend on the time. `first_s`: the time that is drawn
    // first; `rowsAtOnce`: the most that draw() is asked for.
    PictureDrawer(const RenderOptions& options, const Input& input, double first_s, int rowsAtOnce);

    const ContextInfo& context() const
    {
        return context_;
    }
    // The scene at the time of the last moveTo(); null for a plain shader.
    const PreparedScene* prepared() const
    {
        return raster_ ? &raster_->prepared : prepared_ ? &*prepared_ : nullptr;
    }
    // What the making took, milliseconds.
    const Phases& made() const
    {
        return made_;
    }
    DrawingFacts facts() const;

    // Of the layers that draw() gives.
    std::vector<std::string> layerChannels() const;

    void moveTo(double time_s);

    struct Band {
        Still still;
        std::vector<ExrLayer> layers;
    };
    // Rows of the whole width, which begin at a multiple of 64. `progress` is told the share that is drawn,
    // 0..1.
    Band draw(const PixelRectangle& rows, const Progress& progress);

    // A fingerprint of all that decides the pictures but the options and the time: the input's text, the
    // texts of the shaders, and the contents of the pictures that are read.
    unsigned long long sourcesFingerprint() const;

private:
    void makeRenderers(const RenderOptions& options);
    void addTimes(const BuildTimes& times);
    std::string plainSources() const;
    Drawing* drawing() const; // null for the reference
    Still drawReference(const PixelRectangle& rows) const;

    Method method_;
    Input input_;
    ViewSettings settings_;
    PlainSettings plain_; // of a plain shader
    std::string text_;    // of the input's file
    SceneOverTime scene_;
    std::optional<PreparedScene> prepared_; // of a scene that is traced
    std::optional<RasterScene> raster_;     // of one that is rasterised
    std::unique_ptr<Context> glContext_;
    ContextInfo context_;
    std::unique_ptr<Renderer> renderer_;           // of a scene, but of the reference
    std::unique_ptr<PlainRenderer> plainRenderer_; // of a plain shader
    std::unique_ptr<RasterRenderer> rasterRenderer_;
    std::unique_ptr<LayerDrawer> layers_; // where there are any
    Phases made_;
};

} // namespace dioptre
