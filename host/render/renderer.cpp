#include "render/renderer.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/build.h"
#include "render/shared_values.h"
#include "render/still.h"
#include "render/view_picture.h"

#include <algorithm>

namespace dioptre
{
namespace
{

void setSamples(const Program& program, const SampleBatch& batch)
{
    glUniform1i(locationOf(program, "u_sample_first"), batch.first);
    glUniform1i(locationOf(program, "u_sample_count"), batch.count);
}

// The plan for what the part shows, with no more through the vertex stage than the device carries.
Plan planFor(const PreparedScene& prepared, const PicturePart& part)
{
    const int most = std::min(mostSharedVectors, sharedVectorsOfContext());
    const Plan& whole = prepared.plan;
    if (part.seen == whole.seen && vectorsOf(whole.shared) <= most)
        return whole;
    return makePlan(prepared.scene, whole.view, most, part.seen);
}

std::vector<DrawnPart> drawnParts(const std::vector<PartProgram>& programs, const ViewSettings& view)
{
    std::vector<DrawnPart> parts;
    for (const auto& program : programs) {
        double pixels = 0.0;
        for (const auto& r : program.part.rectangles)
            pixels += static_cast<double>(r.area());
        parts.push_back({program.part.name, pixels / view.width / view.height, program.part.rectangles.size(),
                         program.plan, program.shader});
    }
    return parts;
}

} // namespace

Renderer::Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context)
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), prepared_(&prepared), view_(view),
      software_(context.software)
{
    const PackedScene& packed = prepared.packed;
    Stopwatch watch;
    dealSamples();
    for (const auto& part : prepared.parts) {
        const Plan plan = planFor(prepared, part);
        parts_.push_back({part, plan, assemble(prepared.scene, plan, packed, view.glslFolder), {}});
    }
    std::vector<const Plan*> plans;
    for (const auto& part : parts_)
        plans.push_back(&part.plan);
    device_ = upload(packed, plans);
    times_.load = watch.lap_ms();

    for (auto& part : parts_) {
        part.program = buildProgram(part.shader, assembleVertex(part.plan, packed, view.glslFolder));
        checkInterface(part.program, packed, part.plan);
    }
    times_.compile = watch.lap_ms();

    for (const auto& part : parts_) {
        bindTo(part);
        setSamples(part.program, {0, 0}); // adds nothing, yet makes the driver compile
        drawFirst();
    }
    waitForFirst();
    times_.firstDraw = watch.lap_ms();
}

void Renderer::update(const PreparedScene& prepared)
{
    prepared_ = &prepared;
    dealSamples();
    uploadNumbers(device_, prepared.packed);
}

// The same for all parts, so that the samples of every pixel add up in the same order.
void Renderer::dealSamples()
{
    batches_ = sampleBatches(view_.samples, loopIterations(prepared_->plan, prepared_->packed), software_);
}

void Renderer::bindTo(const PartProgram& part) const
{
    bind(part.program, device_, prepared_->packed, {view_.width, view_.height}, {region_.x, region_.y});
}

// Batches bound a draw's loop iterations, its size the time.
void Renderer::drawRegion()
{
    for (const auto& part : parts_) {
        bindTo(part);
        for (const auto& batch : batches_) {
            setSamples(part.program, batch);
            for (const auto& rectangle : part.part.rectangles)
                cover(rectangle);
        }
    }
}

long Renderer::passes() const
{
    return static_cast<long>(batches_.size());
}

PixelCounts Renderer::finish(Picture& picture) const
{
    if (view_.view != DataView::none)
        dataFromSums(picture, view_.view, view_.samples);
    return meansOfSums(picture, view_.samples);
}

DrawingFacts Renderer::facts() const
{
    const PartProgram& fullest = parts_.back();
    DrawingFacts facts;
    facts.shader = fullest.shader;
    facts.uniforms = keysOf(fullest.program.uniforms);
    facts.blocks = keysOf(fullest.program.uniformBlocks);
    facts.parts = drawnParts(parts_, view_);
    facts.textureBytes = device_.textureBytes;
    for (const auto& texture : device_.textures)
        facts.textures.push_back(texture.uniform);
    return facts;
}

} // namespace dioptre
