#include "render/renderer.h"

#include "base/clock.h"
#include "base/text.h"
#include "render/build.h"
#include "render/shader_device.h"
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
    : Renderer(prepared, view, context, {}, nullptr)
{
}

Renderer::Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context,
                   std::vector<AssembledPart> assembled, Renderer* before)
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), prepared_(&prepared), view_(view),
      software_(context.software)
{
    const PackedScene& packed = prepared.packed;
    Stopwatch watch;
    if (assembled.empty())
        assembled = assembleParts(prepared, view.glslFolder,
                                  shaderDevice(view.glslFolder, prepared.plan.choosesKernels()));
    dealSamples();
    for (auto& part : assembled)
        parts_.push_back({std::move(part), {}});
    if (before == nullptr)
        device_ = upload(packed, plans());
    times_.load = watch.lap_ms();

    for (auto& part : parts_) {
        part.program = buildProgram(part.shader, part.vertex);
        checkInterface(part.program, packed, part.plan);
    }
    times_.compile = watch.lap_ms();

    if (before != nullptr)
        device_ = upload(packed, plans(), std::move(before->device_.textures));
    times_.load += watch.lap_ms();

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
    update(prepared, view_);
}

void Renderer::update(const PreparedScene& prepared, const ViewSettings& view)
{
    prepared_ = &prepared;
    view_ = view;
    resize(targetWidth(view), targetHeight(view));
    for (std::size_t i = 0; i < parts_.size(); ++i)
        parts_[i].part.rectangles = prepared.parts[i].rectangles;
    dealSamples();
    uploadNumbers(device_, prepared.packed);
}

void Renderer::updatePictures(const PreparedScene& prepared)
{
    prepared_ = &prepared;
    device_ = {}; // the device need not hold both
    device_ = upload(prepared.packed, plans());
}

std::vector<const Plan*> Renderer::plans() const
{
    std::vector<const Plan*> plans;
    for (const auto& part : parts_)
        plans.push_back(&part.plan);
    return plans;
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
void Renderer::drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area)
{
    for (const auto& part : parts_) {
        bindTo(part);
        for (const auto& batch : batches) {
            setSamples(part.program, batch);
            for (const auto& rectangle : part.part.rectangles)
                cover(common(rectangle, area));
        }
    }
}

std::span<const SampleBatch> Renderer::batches() const
{
    return batches_;
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
