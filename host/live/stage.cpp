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

void dropPictures(Loaded& loaded)
{
    if (loaded.scene) {
        loaded.scene->prepared.packed.pictures.clear();
        loaded.scene->prepared.packed.sky_picture.clear();
    }
    if (loaded.plain)
        loaded.plain->channels = {};
    loaded.trials.clear();
}

} // namespace

Stage::Stage(const ContextInfo& context, const std::filesystem::path& glslFolder)
    : context_(context), shown_(glslFolder)
{
}

Drawing& Stage::drawing() const
{
    return plain_ ? static_cast<Drawing&>(*plain_) : *scene_;
}

int Stage::samplesWanted() const
{
    return plain_ ? 1 : loaded_->view.samples;
}

bool Stage::isDone() const
{
    return loaded_ == nullptr || samplesDone_ >= samplesWanted();
}

void Stage::take(Loaded loaded)
{
    auto next = std::make_unique<Loaded>(std::move(loaded));
    const bool same = loaded_ != nullptr && loaded_->texts == next->texts &&
                      loaded_->scene.has_value() == next->scene.has_value();
    if (same)
        takeValues(std::move(next));
    else
        takeTexts(std::move(next));
    dropPictures(*loaded_);
    lookForMotion();
    begin();
}

void Stage::takeTexts(std::unique_ptr<Loaded> next)
{
    if (next->scene) {
        auto& scene = *next->scene;
        Renderer* const before = loaded_ && loaded_->pictures == next->pictures ? scene_.get() : nullptr;
        auto renderer = std::make_unique<Renderer>(scene.prepared, next->view, context_, scene.parts, before);
        scene_ = std::move(renderer);
        plain_.reset();
    } else {
        plain_ = std::make_unique<PlainRenderer>(*next->plain, next->view, next->plainSettings);
        scene_.reset();
    }
    loaded_ = std::move(next);
    facts_ = {};
    facts_.built = drawing().times();
    facts_.uniforms = drawing().facts().uniforms;
    msPerRow_ = 0.0;
}

// Values alone may make a scene move: its texts need not tell.
void Stage::lookForMotion()
{
    facts_.usesTime = scene_ ? !loaded_->scene->scene->animated.empty()
                             : anyOf(facts_.uniforms, {"iTime", "u_time", "iFrame", "u_frame", "iDate",
                                                       "u_date", "iChannelTime"});
    facts_.usesPointer = plain_ && anyOf(facts_.uniforms, {"iMouse", "u_mouse"});
}

void Stage::takeValues(std::unique_ptr<Loaded> next)
{
    const bool pictures = loaded_->pictures != next->pictures;
    if (scene_) {
        if (pictures)
            scene_->updatePictures(next->scene->prepared);
        scene_->update(next->scene->prepared, next->view);
    } else {
        plain_->update(next->plainSettings.values);
        plain_->update(next->request.look.size_px);
        plain_->moveTo(next->plainSettings.frame);
        if (pictures)
            plain_->update(next->plain->channels);
    }
    loaded_ = std::move(next);
}

void Stage::moveTo(const Look& look, double time_s, const PlainFrame& frame)
{
    loaded_->view.width = look.size_px.x;
    loaded_->view.height = look.size_px.y;
    loaded_->view.samples = look.samples;
    if (scene_) {
        auto& [atTime, shown, prepared, parts] = *loaded_->scene;
        dioptre::moveTo(prepared, sceneUnder(look, atTime, time_s, shown.get()), loaded_->view);
        prepared.parts = {wholePicture(prepared.plan, look.size_px.x, look.size_px.y)};
        scene_->update(prepared, loaded_->view);
    } else {
        PlainFrame whole = frame;
        whole.live.sliders.insert(loaded_->sliders.begin(), loaded_->sliders.end());
        plain_->update(look.size_px);
        plain_->moveTo(whole);
    }
    begin();
}

void Stage::setDisplay(const std::optional<Display>& display)
{
    display_ = display;
    if (samplesDone_ > 0 && row_ == 0)
        show();
}

void Stage::begin()
{
    samplesDone_ = 0;
    row_ = 0;
    facts_.raysPerPixel.reset();
    facts_.nonfinite = 0;
}

void Stage::giveUp()
{
    samplesDone_ = samplesWanted();
    row_ = 0;
}

bool Stage::draw(double budget_ms)
{
    Stopwatch watch;
    bool completed = false;
    const int width = loaded_->view.width, height = loaded_->view.height;
    for (double spent_ms = 0.0; !isDone() && spent_ms < budget_ms;) {
        if (row_ == 0)
            sample_ms_ = 0.0;
        if (row_ == 0 && samplesDone_ == 0)
            drawing().start();
        const double fitting = msPerRow_ > 0.0 ? (budget_ms - spent_ms) / msPerRow_ : leastRows;
        const int rows =
            std::min(height - row_, std::max(leastRows, static_cast<int>(std::min(fitting, 1e6))));
        drawing().add({samplesDone_, 1}, {0, row_, width, rows});
        const double took_ms = watch.lap_ms();
        msPerRow_ = took_ms / rows;
        spent_ms += took_ms;
        sample_ms_ += took_ms;
        row_ += rows;
        if (row_ < height)
            continue;
        row_ = 0;
        ++samplesDone_;
        facts_.sample_ms = sample_ms_;
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

void Stage::show()
{
    const DataView view = loaded_->view.view;
    if (plain_)
        return shown_.take(drawing().target(), 1, std::nullopt);
    if (view == DataView::none)
        return shown_.take(drawing().target(), samplesDone_,
                           display_.value_or(loaded_->scene->prepared.scene.output));
    ShownView shown = shownView(radiance(), loaded_->scene->prepared);
    shown_.take(shown.picture);
    facts_.legend = std::move(shown.legend);
}

Picture Stage::radiance() const
{
    Picture picture = drawing().read();
    if (plain_)
        return picture;
    if (loaded_->view.view != DataView::none)
        dataFromSums(picture, loaded_->view.view, samplesDone_);
    meansOfSums(picture, samplesDone_);
    return picture;
}

// What is looked at once a picture stands still; a driver that ended a plain shader's loops is told there.
void Stage::finish()
{
    if (facts_.usesTime)
        return;
    Picture picture = drawing().read();
    const double samples = samplesDone_;
    const auto pixels = static_cast<double>(picture.width) * picture.height;
    if (plain_) {
        facts_.nonfinite = plain_->finish(picture).nonfinite;
        return;
    }
    const PixelCounts counts = meansOfSums(picture, samplesDone_);
    facts_.nonfinite = counts.nonfinite;
    facts_.raysPerPixel = counts.rays / pixels / samples;
}

} // namespace dioptre
