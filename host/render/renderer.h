// A prepared scene on the device: assembled, uploaded, compiled, and ready to be drawn again and again.
#pragma once

#include "gl/context.h"
#include "render/assembled_part.h"
#include "render/device_scene.h"
#include "render/drawing.h"
#include "render/prepare.h"
#include "render/samples.h"

namespace dioptre
{

// A part of the picture with its own plan and program.
struct PartProgram : AssembledPart {
    Program program;
};

class Renderer final : public Drawing
{
public:
    // On the current context. `prepared` must outlive the renderer. Throws badInput with the author's file
    // and line when the shader does not compile.
    Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context);

    // The same of texts that were assembled before, for what this device carries.
    // `before` draws the very same pictures and gives its textures away once the programs are made; null for
    // none.
    Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context,
             std::vector<AssembledPart> assembled, Renderer* before = nullptr);

    // Goes on with the same scene at another time, as moveTo() left it: nothing is compiled, and no picture
    // is uploaded. `prepared` must outlive the renderer. Throws badInput where a sample now takes more loop
    // iterations than the driver runs.
    void update(const PreparedScene& prepared);

    // The same in a picture of another size, as the parts of `prepared` fill it.
    void update(const PreparedScene& prepared, const ViewSettings& view);

    // The same with other pictures, which are uploaded anew. The texts of its shaders are the same.
    void updatePictures(const PreparedScene& prepared);

    // From the sums of the samples in rgb and the rays traced in alpha: means, and alpha 1; of a view its
    // data.
    PixelCounts finish(Picture& picture) const override;

    DrawingFacts facts() const override;

    // What each part of the picture is drawn by, the fullest last.
    const std::vector<PartProgram>& parts() const
    {
        return parts_;
    }

protected:
    void drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area) override;
    std::span<const SampleBatch> batches() const override;

private:
    void bindTo(const PartProgram& part) const;
    std::vector<const Plan*> plans() const;
    void dealSamples();

    const PreparedScene* prepared_;
    ViewSettings view_;
    bool software_; // the driver
    std::vector<SampleBatch> batches_;
    std::vector<PartProgram> parts_;
    DeviceScene device_;
};

} // namespace dioptre
