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

Plan fitting(const PreparedScene& prepared)
{
    const int most = sharedVectorsOfContext();
    return vectorsOf(prepared.plan.shared) <= most ? prepared.plan
                                                   : makePlan(prepared.scene, prepared.plan.view, most);
}

} // namespace

Renderer::Renderer(const PreparedScene& prepared, const ViewSettings& view, const ContextInfo& context)
    : prepared_(prepared), plan_(fitting(prepared)), view_(view)
{
    const Scene& scene = prepared.scene;
    const PackedScene& packed = prepared.packed;
    const Plan& plan = plan_;
    Stopwatch watch;
    batches_ = sampleBatches(view.samples, loopIterations(plan, packed), context.software);
    shader_ = assemble(scene, plan, packed, view.glslFolder);
    device_ = upload(packed, plan);
    target_ = makeAccumulationTarget(view.width, view.height);
    times_.load = watch.lap_ms();

    program_ = buildProgram(shader_, assembleVertex(plan, packed, view.glslFolder));
    checkInterface(program_, device_, plan);
    times_.compile = watch.lap_ms();

    bind(program_, device_, packed, view.width, view.height);
    setSamples(program_, {0, 0}); // adds nothing, yet makes the driver compile
    drawAdding(target_, 0, 0, 1, 1);
    glFinish();
    times_.firstDraw = watch.lap_ms();
}

void Renderer::draw(const std::function<void(double)>& progress)
{
    submit(progress);
    glFinish();
}

// Tiles bound the time of a draw, batches its loop iterations.
void Renderer::submit(const std::function<void(double)>& progress)
{
    constexpr int tile_px = 512;
    const int columns = (view_.width + tile_px - 1) / tile_px;
    const int rows = (view_.height + tile_px - 1) / tile_px;
    const double total = static_cast<double>(batches_.size()) * columns * rows;
    double done = 0.0;
    clear(target_);
    bind(program_, device_, prepared_.packed, view_.width, view_.height);
    for (const auto& batch : batches_) {
        setSamples(program_, batch);
        for (int y = 0; y < view_.height; y += tile_px) {
            for (int x = 0; x < view_.width; x += tile_px) {
                drawAdding(target_, x, y, std::min(tile_px, view_.width - x),
                           std::min(tile_px, view_.height - y));
                if (progress) {
                    glFinish();
                    progress(++done / total);
                }
            }
        }
    }
}

Picture Renderer::read() const
{
    return readBack(target_);
}

} // namespace dioptre
