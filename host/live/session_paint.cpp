#include "live/session.h"

#include "base/interruption.h"
#include "gl/object_count.h"

#include <algorithm>

namespace dioptre
{
namespace
{

using Clock = LiveClock::Clock;

constexpr double frame_s = 1.0 / 60.0;
constexpr double yieldedShare = 0.6;   // of a frame, to the compiler after each
constexpr double drawBudget_ms = 25.0; // between two looks at the keys
constexpr double notice_s = 4.0;
constexpr double look_s = 0.15; // between two looks at the plan while the camera moves
constexpr double lost_s = 1.0;  // from a reload to the measuring of lost weight
constexpr std::size_t framesKept = 120;

double since_s(Clock::time_point then)
{
    return std::chrono::duration<double>(Clock::now() - then).count();
}

} // namespace

// A picture that refines itself and is to be replaced leaves the processor to the compiler.
bool Session::isToDraw() const
{
    const bool refines = stage_.samplesDone() > 0 && !stage_.isBegun();
    return stage_.loaded() != nullptr && !stage_.isDone() && !(refines && reloader_.compilingFor_s() > 0.0);
}

// Nothing to do: a signal's mark is looked for now and then. X, files and threads end the wait themselves.
double Session::waitTime_s()
{
    const bool draws = isToDraw();
    const bool plays = stage_.loaded() != nullptr && stage_.facts().usesTime && !model_.clock.isPaused();
    const bool compiles = reloader_.compilingFor_s() > 0.0;
    // The compiler works at low priority: a picture that runs leaves it some of its time.
    if (compiles && (plays || moved_) && !stage_.isBegun())
        return std::clamp(0.001 * yieldedShare * stage_.sample_ms(), 0.0, 0.5);
    if (draws || paints_ > 0 || moved_)
        return 0.0;
    if (plays || flies_)
        return std::max(0.0005, frame_s - since_s(lastFrame_));
    if (reloader_.compilingFor_s() > 0.0 || !model_.notice.empty() || looksElsewhere_ || shot_)
        return 0.1;
    return 0.5;
}

void Session::follow()
{
    if (!model_.notice.empty() && since_s(noticedAt_) > notice_s) {
        model_.notice.clear();
        paints_ = 2;
    }
    if (reloader_.compilingFor_s() > 0.2)
        paints_ = std::max(paints_, 1);
    if (const glm::ivec2 size = window_.size_px(); size.x > 0 && size.y > 0 && size != model_.look.size_px) {
        model_.look.size_px = size;
        moved_ = true;
    }
    if (stage_.loaded() == nullptr)
        return;
    // Once the user looks on: an edit that comes meanwhile would have to wait for a new helper.
    if (model_.showPanel && wasDone_ && !lostMeasured_ && !reloader_.isBusy() && since_s(takenAt_) > lost_s) {
        lostMeasured_ = true;
        if (stage_.loaded()->scene && !stage_.loaded()->scene->parts.empty() &&
            stage_.loaded()->scene->prepared.plan.tree != RayTree::single &&
            model_.look.view == DataView::none)
            reloader_.measureLost(wanted(model_), model_.clock.time_s(), *stage_.loaded());
    }
    // Features that another place needs are found by planning anew, beside the picture.
    if (looksElsewhere_ && since_s(lookedAt_) > look_s && !reloader_.isBusy()) {
        looksElsewhere_ = false;
        lookedAt_ = Clock::now();
        ask();
    }
    const bool plays = stage_.facts().usesTime && !model_.clock.isPaused();
    const bool due = plays && since_s(lastFrame_) >= frame_s;
    // A frame that was begun is ended first, or a slow picture would never be seen under a moving hand.
    const bool begun = stage_.samplesDone() == 0 && !stage_.isDone() && stage_.isBegun();
    if ((moved_ || due) && !begun) {
        model_.frame.time_s = model_.clock.time_s();
        try {
            stage_.moveTo(wanted(model_), model_.clock.time_s(), model_.frame);
        } catch (const Error& error) { // a mixture of good keys may be no good
            fail(error);
        }
        model_.frame.pointer.nextFrame();
        moved_ = false;
        wasDone_ = false;
    }
}

void Session::sayDone() const
{
    if (!log_.isOn())
        return;
    nlohmann::ordered_json details = {{"samples", stage_.samplesDone()}};
    details.update(methodDetails());
    details["gl_objects"] = countGlObjects();
    log_.say("done", std::move(details));
}

void Session::paint()
{
    bool fresh = false; // a frame of the picture
    paints_ = std::max(paints_, window_.takeDamage() ? 1 : 0);
    const glm::ivec2 size_px = window_.size_px();
    if (size_px.x == 0 || size_px.y == 0)
        return;
    if (isToDraw()) {
        try {
            fresh = stage_.draw(drawBudget_ms);
        } catch (const Error& error) {
            stage_.giveUp();
            if (Interruption::signal() == 0)
                fail(error);
        }
    }
    if (stage_.loaded() != nullptr && stage_.isDone() && !wasDone_) {
        wasDone_ = true;
        if (!stage_.facts().usesTime || model_.clock.isPaused())
            sayDone();
        paints_ = std::max(paints_, 1);
    }
    rested_ = rested_ || (!fresh && !isToDraw());
    if (!fresh && paints_ <= 0)
        return;
    paints_ = std::max(0, paints_ - 1);
    stage_.present(size_px);
    // Where it shows nothing too: only so it lets go of a pointer that was over it.
    grant(
        ui_.draw(model_, {stage_, frames_ms_, reloader_.compilingFor_s(), window_.context(), dividerHeld_}));
    window_.swap();
    if (fresh) {
        if (!std::exchange(rested_, false))
            frames_ms_.push_back(static_cast<float>(1000.0 * since_s(lastFrame_)));
        if (frames_ms_.size() > framesKept)
            frames_ms_.pop_front();
        lastFrame_ = Clock::now();
        ++framesShown_;
        picturesShown_ = picturesTaken_;
    }
}

void Session::grant(const UiWishes& wishes)
{
    for (const auto& path : wishes.dropped) {
        model_.changes.erase(path);
        model_.frame.live.sliders.erase(path);
    }
    for (const auto& [path, value] : wishes.changes)
        model_.changes[path] = value;
    if (!wishes.changes.empty() || !wishes.dropped.empty())
        ask();
    if (wishes.camera)
        setCamera(*wishes.camera);
    for (const auto& [name, numbers] : wishes.sliders)
        model_.frame.live.sliders[name] = numbers;
    moved_ = moved_ || !wishes.sliders.empty();
    if (wishes.display) {
        model_.display = *wishes.display;
        stage_.setDisplay(model_.display);
        paints_ = std::max(paints_, 1);
    }
    if (wishes.methods)
        choose(*wishes.methods);
    if (wishes.time_s) {
        model_.clock.jumpTo(*wishes.time_s);
        moved_ = true;
    }
    for (const Action action : wishes.actions)
        act(action);
}

} // namespace dioptre
