// A scene on the device, drawn from facets.
#pragma once

#include "gl/context.h"
#include "raster/mesh_buffer.h"
#include "raster/object_buffer.h"
#include "raster/raster_text.h"
#include "raster/sample_target.h"
#include "raster/shadow_pass.h"
#include "render/device_scene.h"
#include "render/drawing.h"

#include <optional>

namespace dioptre
{

class RasterRenderer final : public Drawing
{
public:
    // On the current context. `raster` must outlive the renderer. Throws badInput with the author's file and
    // line when a shader does not compile, and where the scene's lights are more than the method can hand on.
    RasterRenderer(const RasterScene& raster, const ViewSettings& view);

    // The same of texts that were assembled before.
    RasterRenderer(const RasterScene& raster, const ViewSettings& view, RasterTexts texts);

    // Goes on with the same scene at another time, as moveTo() left it: nothing is compiled, no picture is
    // uploaded, shadow maps are drawn anew. `raster` must outlive the renderer.
    void update(const RasterScene& raster);

    // The same in a picture of another size.
    void update(const RasterScene& raster, const ViewSettings& view);

    // The same with other pictures, which are uploaded anew.
    void updatePictures(const RasterScene& raster);

    // From the sums of the samples in rgb: means, and alpha 1.
    PixelCounts finish(Picture& picture) const override;

    DrawingFacts facts() const override;
    RasterFacts rasterFacts() const;

    // Of all its programs.
    std::vector<RasterText> texts() const
    {
        return textsOfAll(texts_);
    }

    // Facets' edges over the picture; off at first. Throws badInput where their shader does not compile.
    void showWires(bool on);

protected:
    void drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area) override;
    std::span<const SampleBatch> batches() const override;

private:
    void build();
    void placeObjects();
    void dealSamples();
    void drawSample(const PixelRectangle& cell, int sample, const PixelRectangle& area);
    void drawSky(const PixelRectangle& cell, int sample);
    void drawWires(const PixelRectangle& cell, int sample);
    void drawObjects(const Program& program) const;
    void use(const Program& program, const PixelRectangle& cell, int sample) const;

    const RasterScene* raster_;
    ViewSettings view_;
    RasterTexts texts_;
    std::vector<SampleBatch> batches_;
    std::optional<Program> surface_; // none of an empty scene
    std::optional<Program> wire_;    // once it was asked for
    Program sky_, add_;
    DeviceScene device_;
    MeshBuffers meshes_;
    ObjectBuffer objectNumbers_;
    VertexArray noVertices_; // of the full-screen triangle
    std::optional<SampleTarget> sample_;
    ShadowPass shadows_;
    std::vector<bool> seen_; // by object
    bool wires_ = false;
};

} // namespace dioptre
