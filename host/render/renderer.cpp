#include "render/renderer.h"

#include "base/clock.h"
#include "render/build.h"
#include "render/shared_values.h"

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

} // namespace

Renderer::Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context)
    : prepared_(&prepared), view_(view)
{
    const PackedScene& packed = prepared.packed;
    Stopwatch watch;
    // The same for all parts, so that the samples of every pixel add up in the same order.
    batches_ = sampleBatches(view.samples, loopIterations(prepared.plan, packed), context.software);
    for (const auto& part : prepared.parts) {
        const Plan plan = planFor(prepared, part);
        parts_.push_back({part, plan, assemble(prepared.scene, plan, packed, view.glslFolder), {}});
    }
    std::vector<const Plan*> plans;
    for (const auto& part : parts_)
        plans.push_back(&part.plan);
    device_ = upload(packed, plans);
    target_ = makeAccumulationTarget(view.width, view.height);
    times_.load = watch.lap_ms();

    for (auto& part : parts_) {
        part.program = buildProgram(part.shader, assembleVertex(part.plan, packed, view.glslFolder));
        checkInterface(part.program, packed, part.plan);
    }
    times_.compile = watch.lap_ms();

    for (const auto& part : parts_) {
        bind(part.program, device_, packed, view.width, view.height);
        setSamples(part.program, {0, 0}); // adds nothing, yet makes the driver compile
        drawAdding(target_, 0, 0, 1, 1);
    }
    glFinish();
    times_.firstDraw = watch.lap_ms();
}

void Renderer::update(const PreparedScene& prepared)
{
    prepared_ = &prepared;
    uploadNumbers(device_, prepared.packed);
}

// Rectangles bound the time of a draw, batches its loop iterations.
void Renderer::submit(const std::function<void(double)>& progress)
{
    constexpr int most_px = 512;
    const double total = static_cast<double>(batches_.size()) * view_.width * view_.height;
    double done = 0.0;
    const auto drawRectangle = [&](const PixelRectangle& r) {
        drawAdding(target_, r.x, r.y, r.width, r.height);
        if (!progress)
            return;
        glFinish();
        done += static_cast<double>(r.width) * r.height;
        progress(done / total);
    };
    clear(target_);
    for (const auto& part : parts_) {
        bind(part.program, device_, prepared_->packed, view_.width, view_.height);
        for (const auto& batch : batches_) {
            setSamples(part.program, batch);
            for (const auto& r : part.part.rectangles)
                for (int y = 0; y < r.height; y += most_px)
                    for (int x = 0; x < r.width; x += most_px)
                        drawRectangle({r.x + x, r.y + y, std::min(most_px, r.width - x),
                                       std::min(most_px, r.height - y)});
        }
    }
}

Picture Renderer::read() const
{
    return readBack(target_);
}

} // namespace dioptre
