#include "live/stage.h"

#include "base/clock.h"
#include "render/still.h"

#include <algorithm>
#include <set>

namespace dioptre
{
namespace
{

// Drawn at once at least, so that drawing and not waiting takes the time.
constexpr int leastRows = 16;

// A view's colours look at the whole picture, on the CPU: that is not done for every sample.
bool isShownAt(int samples, int wanted)
{
    return samples == wanted || (samples & (samples - 1)) == 0;
}

bool anyOf(const std::vector<std::string>& names, const std::set<std::string>& wanted)
{
    return std::ranges::any_of(names, [&](const auto& name) { return wanted.contains(name); });
}

void dropPictures(PackedScene& packed)
{
    packed.pictures.clear();
    packed.sky_picture.clear();
}

void dropPictures(Loaded& loaded)
{
    if (loaded.scene) {
        dropPictures(loaded.scene->prepared.packed);
        for (auto& raster : loaded.scene->rasters)
            if (raster)
                dropPictures(raster->scene.prepared.packed);
    }
    if (loaded.plain)
        loaded.plain->channels = {};
    loaded.trials.clear();
}

} // namespace

Stage::Stage(const ContextInfo& context, const std::filesystem::path& glslFolder)
    : context_(context), glslFolder_(glslFolder)
{
    shown_.push_back(std::make_unique<ShownPicture>(glslFolder));
}

int Stage::samplesWanted() const
{
    return isPlain() ? 1 : loaded_->view.samples;
}

bool Stage::isDone() const
{
    return loaded_ == nullptr || samplesDone_ >= samplesWanted();
}

void Stage::take(Loaded loaded)
{
    auto next = std::make_unique<Loaded>(std::move(loaded));
    std::vector<Painter*> before; // for what they have shown
    for (const Layer& layer : layers_)
        before.push_back(layer.painter.get());
    layers_ = layersFor(*next);
    loaded_ = std::move(next);
    keepShown(before);
    dropPictures(*loaded_);
    for (const Layer& layer : layers_)
        layer.painter->showWires(choice_.wires);
    lookForMotion();
    begin();
}

// Those that go on have other values, and the others are made anew; what was shown stays where one cannot be
// made. The tracer comes last: it takes textures over.
std::vector<Stage::Layer> Stage::layersFor(const Loaded& next)
{
    std::vector<Layer> layers(next.drawn.size());
    std::vector<Layer*> goOn(next.drawn.size(), nullptr);
    Painter* tracer = nullptr;
    for (Layer& layer : layers_) {
        for (std::size_t i = 0; i < layers.size(); ++i)
            if (layer.painter->serves(next, i))
                goOn[i] = &layer;
        if (!isRasterised(layer.painter->method()))
            tracer = layer.painter.get();
    }
    BuildTimes built;
    bool any = false;
    for (const bool rasterised : {true, false})
        for (std::size_t i = 0; i < layers.size(); ++i) {
            if (goOn[i] != nullptr || isRasterised(next.drawn[i].method) != rasterised)
                continue;
            layers[i].painter = std::make_unique<Painter>(next, i, context_, tracer);
            const BuildTimes& times = layers[i].painter->drawing().times();
            built.load += times.load;
            built.compile += times.compile;
            built.firstDraw += times.firstDraw;
            any = true;
        }
    updateAll(next, goOn);
    for (std::size_t i = 0; i < layers.size(); ++i)
        if (goOn[i] != nullptr)
            layers[i] = std::move(*goOn[i]);
    if (any) {
        facts_ = {};
        facts_.built = built;
        facts_.uniforms = layers.front().painter->drawing().facts().uniforms;
    }
    return layers;
}

// All of those or, where one cannot go on so, none: they go on with what is shown.
void Stage::updateAll(const Loaded& next, const std::vector<Layer*>& layers)
{
    try {
        for (std::size_t i = 0; i < layers.size(); ++i)
            if (layers[i] != nullptr)
                layers[i]->painter->update(next, i);
    } catch (...) {
        for (std::size_t i = 0; i < layers_.size(); ++i)
            layers_[i].painter->update(*loaded_, i);
        throw;
    }
}

// A picture goes with its painter; that of a painter which is no more stays in its place until the next is
// drawn.
void Stage::keepShown(const std::vector<Painter*>& before)
{
    std::vector<std::unique_ptr<ShownPicture>> kept(layers_.size());
    for (std::size_t i = 0; i < layers_.size(); ++i)
        for (std::size_t j = 0; j < before.size(); ++j)
            if (layers_[i].painter.get() == before[j])
                kept[i] = std::move(shown_[j]);
    for (std::size_t i = 0; i < layers_.size(); ++i) {
        if (!kept[i] && i < shown_.size())
            kept[i] = std::move(shown_[i]);
        if (!kept[i])
            kept[i] = std::make_unique<ShownPicture>(glslFolder_);
    }
    shown_ = std::move(kept);
}

// Values alone may make a scene move: its texts need not tell.
void Stage::lookForMotion()
{
    facts_.usesTime = !isPlain() ? !loaded_->scene->scene->animated.empty()
                                 : anyOf(facts_.uniforms, {"iTime", "u_time", "iFrame", "u_frame", "iDate",
                                                           "u_date", "iChannelTime"});
    facts_.usesPointer = isPlain() && anyOf(facts_.uniforms, {"iMouse", "u_mouse"});
}

void Stage::moveTo(const Look& look, double time_s, const PlainFrame& frame)
{
    loaded_->view.width = look.size_px.x;
    loaded_->view.height = look.size_px.y;
    loaded_->view.samples = look.samples;
    if (PlainRenderer* const plain = layers_.front().painter->plain()) {
        PlainFrame whole = frame;
        whole.live.sliders.insert(loaded_->sliders.begin(), loaded_->sliders.end());
        plain->update(look.size_px);
        plain->moveTo(whole);
        return begin();
    }
    auto& [atTime, shown, prepared, parts, rasters] = *loaded_->scene;
    const Scene scene = sceneUnder(look, atTime, time_s, shown.get());
    dioptre::moveTo(prepared, scene, loaded_->view);
    prepared.parts = {wholePicture(prepared.plan, look.size_px.x, look.size_px.y)};
    for (auto& raster : rasters)
        if (raster)
            dioptre::moveTo(raster->scene, scene, loaded_->view);
    for (const Layer& layer : layers_)
        layer.painter->move(loaded_->view);
    begin();
}

void Stage::begin()
{
    samplesDone_ = 0;
    turn_ = 0;
    row_ = 0;
    facts_.raysPerPixel.reset();
    facts_.nonfinite = 0;
    lookAtMethods();
}

void Stage::lookAtMethods()
{
    facts_.methods.clear();
    for (const Layer& layer : layers_)
        facts_.methods.push_back({layer.painter->method(), layer.sample_ms, layer.painter->rasterFacts()});
}

double Stage::sample_ms() const
{
    double all_ms = 0.0;
    for (const MethodFacts& facts : facts_.methods)
        all_ms += facts.sample_ms;
    return all_ms;
}

void Stage::giveUp()
{
    samplesDone_ = samplesWanted();
    turn_ = 0;
    row_ = 0;
}

// Some of the next sample of the layer whose turn it is. Facets are drawn all at once: what their corners
// take is not less for fewer rows.
void Stage::drawRows(double budget_ms)
{
    Layer& layer = layers_[turn_];
    Drawing& drawing = layer.painter->drawing();
    const int width = loaded_->view.width, height = loaded_->view.height;
    Stopwatch watch;
    if (row_ == 0)
        layer.drawing_ms = 0.0;
    if (row_ == 0 && samplesDone_ == 0)
        drawing.start();
    const double fitting = layer.msPerRow > 0.0 ? budget_ms / layer.msPerRow : leastRows;
    const int least = isRasterised(layer.painter->method()) ? height : leastRows;
    const int rows = std::min(height - row_, std::max(least, static_cast<int>(std::min(fitting, 1e6))));
    drawing.add({samplesDone_, 1}, {0, row_, width, rows});
    const double took_ms = watch.lap_ms();
    layer.msPerRow = took_ms / rows;
    layer.drawing_ms += took_ms;
    row_ += rows;
    if (row_ < height)
        return;
    row_ = 0;
    layer.sample_ms = layer.drawing_ms;
    facts_.methods[turn_].sample_ms = layer.sample_ms;
    turn_ = (turn_ + 1) % layers_.size();
    if (turn_ == 0)
        ++samplesDone_;
}

bool Stage::draw(double budget_ms)
{
    Stopwatch watch;
    bool completed = false;
    for (double spent_ms = 0.0; !isDone() && spent_ms < budget_ms;) {
        drawRows(budget_ms - spent_ms);
        spent_ms += watch.lap_ms();
        if (isBegun())
            continue;
        completed = true;
        // Before the next sample is added to the sums.
        if (isShownAt(loaded_->view.view == DataView::none ? 1 : samplesDone_, samplesWanted()))
            show();
        if (facts_.usesTime)
            break; // the next frame is another moment's
        watch.lap_ms();
    }
    if (completed && isDone())
        finish();
    return completed;
}

// What is looked at once a picture stands still; a driver that ended a plain shader's loops is told there.
void Stage::finish()
{
    if (facts_.usesTime)
        return;
    facts_.nonfinite = 0;
    for (const Layer& layer : layers_) {
        Picture picture = layer.painter->drawing().read();
        if (const PlainRenderer* plain = layer.painter->plain()) {
            facts_.nonfinite = plain->finish(picture).nonfinite;
            return;
        }
        const auto pixels = static_cast<double>(picture.width) * picture.height;
        const PixelCounts counts = meansOfSums(picture, samplesDone_);
        facts_.nonfinite += counts.nonfinite;
        if (!isRasterised(layer.painter->method()))
            facts_.raysPerPixel = counts.rays / pixels / samplesDone_;
    }
}

} // namespace dioptre
