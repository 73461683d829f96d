#include "live/session.h"

#include "base/clock.h"
#include "base/interruption.h"
#include "command/plain_options.h"
#include "gl/object_count.h"
#include "render/pack.h"
#include "render/shader_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace dioptre
{
namespace
{

using Clock = LiveClock::Clock;

DeviceTraits traitsOf(const ContextInfo& context, double drawLimit_s)
{
    return {context.software, shaderDevice(glslFolder()), drawLimit_s};
}

glm::ivec2 sizeOf(const LiveOptions& options, const std::optional<Remembered>& remembered)
{
    if (options.width > 0)
        return {options.width, options.height};
    return remembered && remembered->size_px.x > 0 && remembered->size_px.y > 0 ? remembered->size_px
                                                                                : glm::ivec2(1280, 720);
}

std::optional<Remembered> recallFor(const LiveOptions& options)
{
    return options.forget ? std::nullopt : recall(findLiveInput(options.input).shownFile());
}

nlohmann::ordered_json placesOf(const Fault& fault)
{
    auto places = nlohmann::ordered_json::array();
    for (const auto& [complaint, excerpt] : fault.places)
        places.push_back({{"path", complaint.where.path},
                          {"line", complaint.where.line},
                          {"column", complaint.where.column},
                          {"what", complaint.what},
                          {"mend", complaint.mend}});
    return places;
}

} // namespace

Session::Session(const LiveOptions& options)
    : options_(options), remembered_(recallFor(options)), model_(options), log_(options.json),
      window_(sizeOf(options, remembered_), "dioptre live: " + options.input),
      stage_(window_.context(), glslFolder()),
      reloader_(traitsOf(window_.context(), options.drawLimit_s), [] { Window::wake(); }), ui_(window_)
{
    model_.look.places = searchPlaces(options.included);
    model_.look.channels = options.channels;
    model_.look.samples = options.samples;
    model_.look.view = dataViewNamed(options.view);
    model_.look.size_px = window_.size_px();
    model_.given = options.overrides;
    model_.showPanel = !options.hidePanel && (!remembered_ || remembered_->panel);
    openAgain(findLiveInput(options.input));
}

void Session::openAgain(const LiveInput& input)
{
    input_ = input;
    model_.look.input = input;
    if (!input.picture.empty()) {
        model_.look.channels = {input.picture + "?filter=nearest"};
    }
    if (input.plainShader) {
        model_.look.values = plainValues(model_.given);
        if (!input.picture.empty())
            model_.look.values["u_encode"] = input.isLinear ? "true" : "false";
        model_.frame.rate = options_.fps;
    }
    window_.setTitle("dioptre live: " + input.name);
    ask();
}

Session::~Session()
{
    keep();
}

void Session::keep() const
{
    if (options_.forget || !showsInput())
        return;
    Remembered what{
        window_.isFullscreen() ? window_.sizeOnDesktop_px() : model_.look.size_px, model_.showPanel, {}, {}};
    if (stage_.loaded()->scene && model_.look.camera) {
        what.hand = model_.look.camera;
        what.own = stage_.loaded()->scene->atTime(0.0).camera;
    }
    try {
        remember(input_.shownFile(), what);
    } catch (const Error& error) {
        std::fprintf(stderr, "dioptre: what is remembered of this input is lost: %s\n", error.what());
    }
}

// What was opened last may be faulty: then another's picture is shown still.
bool Session::showsInput() const
{
    return stage_.loaded() != nullptr && stage_.loaded()->request.look.input.path == model_.look.input.path;
}

// Once the file says the same: until it does, the hand's is the one that is seen.
void Session::forgetWrittenCamera()
{
    if (!stage_.loaded()->scene || !model_.look.camera)
        return;
    const Camera own = stage_.loaded()->scene->atTime(model_.clock.time_s()).camera;
    if (own.eye == model_.look.camera->eye && own.target == model_.look.camera->target &&
        own.fovY_deg == model_.look.camera->fovY_deg)
        model_.look.camera.reset();
}

// A scene whose own camera was edited since begins there.
void Session::recallHand()
{
    const auto remembered = std::exchange(remembered_, std::nullopt);
    if (!remembered || !remembered->hand || !stage_.loaded()->scene)
        return;
    const Camera own = stage_.loaded()->scene->atTime(0.0).camera;
    if (own.eye == remembered->own.eye && own.target == remembered->own.target &&
        own.fovY_deg == remembered->own.fovY_deg)
        setCamera(*remembered->hand);
}

// What was changed by hand belongs to what was open before.
void Session::open(const std::filesystem::path& path)
{
    try {
        const LiveInput input = findLiveInput(path.string());
        keep();
        remembered_ = options_.forget ? std::nullopt : recall(input.shownFile());
        model_.changes.clear();
        model_.given.clear();
        model_.look.values.clear();
        model_.look.camera.reset();
        model_.display.reset();
        model_.look.view = DataView::none;
        model_.look.channels = {};
        model_.frame = {};
        openAgain(input);
        log_.say("opened", {{"input", path.string()}});
    } catch (const Error& error) {
        refuse(error);
    }
}

void Session::ask()
{
    model_.frame.time_s = model_.clock.time_s();
    reloader_.ask(wanted(model_), model_.clock.time_s(), model_.frame, stage_.loaded());
}

void Session::fail(const Error& error)
{
    model_.fault = faultOf(error);
    std::fprintf(stderr, "dioptre: %s\n", error.what());
    log_.say("error", {{"text", error.what()},
                       {"code", static_cast<int>(error.code())},
                       {"stale", true},
                       {"places", placesOf(*model_.fault)}});
    paints_ = 3;
}

// A value that was changed by hand may be good no more once the file is another.
void Session::dropFaultyChanges(const Error& error)
{
    const auto& where = error.complaints().front().where.path;
    for (const auto& [path, value] : model_.changes)
        if (where == "--set " + path + "=" + value) {
            notice("dropped " + path + ", which the file takes no more");
            model_.changes.erase(path);
            return ask();
        }
    fail(error);
}

void Session::apply(ReloadOutcome outcome)
{
    if (outcome.lost) {
        model_.lost = *outcome.lost;
        paints_ = std::max(paints_, 1);
        return;
    }
    if (outcome.error)
        return dropFaultyChanges(*outcome.error);
    Stopwatch watch;
    const bool compiled = outcome.compile_ms > 0.0;
    const double load_ms = outcome.loaded->load_ms;
    const bool first = stage_.loaded() == nullptr;
    try {
        stage_.take(std::move(*outcome.loaded));
        stage_.compare(model_.methods);
        stage_.setDisplay(model_.display); // another file's, or one that is written by now, holds no more
    } catch (const Error& error) {
        return fail(error);
    }
    const double window_ms = watch.lap_ms();
    const BuildTimes& built = stage_.facts().built;
    model_.reload = {
        load_ms, outcome.compile_ms + outcome.firstDraw_ms, window_ms, outcome.waited_ms + window_ms,
        compiled && built.compile + built.firstDraw < 0.5 * (outcome.compile_ms + outcome.firstDraw_ms)};
    if (model_.fault)
        std::fprintf(stderr, "dioptre: mended\n");
    model_.fault.reset();
    if (model_.restartOnReload && !first)
        model_.clock.restart();
    ++picturesTaken_;
    reloader_.stand(wanted(model_), model_.clock.time_s(), model_.frame, stage_.loaded());
    takenAt_ = Clock::now();
    lostMeasured_ = false;
    if (remembered_)
        recallHand();
    forgetWrittenCamera();
    moved_ = true; // the window may be of another size by now
    wasDone_ = false;
    paints_ = 3;
    nlohmann::ordered_json details = {{"number", outcome.number},
                                      {"input", model_.look.input.path.string()},
                                      {"compiled", compiled},
                                      {"load_ms", load_ms},
                                      {"compile_ms", outcome.compile_ms},
                                      {"first_draw_ms", outcome.firstDraw_ms},
                                      {"window_ms", window_ms},
                                      {"total_ms", model_.reload.total_ms}};
    details.update(methodDetails());
    if (log_.isOn())
        details["gl_objects"] = countGlObjects();
    log_.say("shown", std::move(details));
}

bool Session::turn()
{
    window_.wait(waitTime_s());
    if (Interruption::signal() != 0)
        window_.close();
    if (window_.isClosing()) {
        window_.hide(); // what is under way may take a moment to end
        return false;
    }
    const auto now = Clock::now();
    const double elapsed_s = std::chrono::duration<double>(now - lastTurn_).count();
    lastTurn_ = now;
    for (const auto& event : window_.takeEvents()) {
        handle(event);
        paints_ = 3;
    }
    fly(std::min(elapsed_s, 0.1));
    if (const auto fault = reloader_.takeWatchFault()) {
        std::fprintf(stderr, "dioptre: %s\n", fault->what());
        notice(fault->what());
    }
    if (reloader_.hasMissedAChange())
        ask();
    while (auto outcome = reloader_.step(stage_.loaded()))
        apply(std::move(*outcome));
    hearOfScreenshot();
    follow();
    paint();
    return true;
}

} // namespace dioptre
