#include "live/reloader.h"

#include "live/load_once.h"
#include "render/build.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// The reply's fault as an error at the author's lines; nothing where it has none.
std::optional<Error> errorOf(const TrialReply& reply, const Loaded& loaded)
{
    const std::string path = loaded.request.look.input.path.string();
    try {
        if (!reply.fault.empty())
            fail(ExitCode::badInput, {path}, reply.fault,
                 "look for a loop that does not end, or for what this driver may not take");
        for (std::size_t i = 0; i < reply.outcomes.size(); ++i) {
            const TrialOutcome& outcome = reply.outcomes[i];
            if (!outcome.messages.empty())
                failToBuild({outcome.messages, outcome.inVertexStage}, loaded.trials[i].fragment,
                            loaded.trials[i].vertex);
            if (loaded.trials[i].program.marksEndedLoops && outcome.endedLoops > 0)
                failForEndedLoops(path, outcome.endedLoops);
        }
    } catch (const Error& error) {
        return error;
    }
    return std::nullopt;
}

// It was loaded for a device that had them, and others have come between.
bool lacksPictures(const Loaded& loaded, const Loaded* shown)
{
    const auto holds = [](const std::vector<DrawnBy>& all, const DrawnBy& one) {
        return std::ranges::find(all, one) != all.end();
    };
    return loaded.scene && std::ranges::any_of(loaded.drawn, [&](const DrawnBy& drawn) {
               return holds(loaded.request.onDevice, drawn) &&
                      (shown == nullptr || !holds(shown->drawn, drawn));
           });
}

// The same of programs.
bool lacksTrials(const Loaded& loaded, const Loaded* shown)
{
    return std::ranges::any_of(loaded.drawn, [&](const DrawnBy& drawn) {
        return holdsTexts(loaded.request.onDevice, drawn.texts) &&
               (shown == nullptr || !holdsTexts(shown->drawn, drawn.texts));
    });
}

} // namespace

Reloader::Reloader(const DeviceTraits& device, std::function<void()> wake)
    : device_(device), loader_(device, wake), watcher_([this] { heardOfFiles(); }), trier_(wake)
{
}

// From the watcher's own thread.
void Reloader::heardOfFiles()
{
    try {
        if (!watcher_.changed().empty())
            loader_.again();
    } catch (const Error& error) { // of something new in a folder; what else has changed is told next
        tellWatchFault(error);
        loader_.again();
    }
}

LoadRequest Reloader::requestOf(const Look& look, double time_s, const PlainFrame& frame,
                                const Loaded* shown) const
{
    LoadRequest request;
    request.look = look;
    request.time_s = time_s;
    request.frame = frame;
    if (shown != nullptr && shown->request.look.input.path == look.input.path) {
        request.onDevice = shown->drawn;
        // Features latch on what is on its way already, so that it need not be compiled again.
        const bool follows = pending_ && pending_->request.look.input.path == look.input.path;
        const Loaded& latest = follows ? *pending_ : *shown;
        if (latest.scene)
            request.shown = latest.scene->scene;
    }
    return request;
}

void Reloader::ask(const Look& look, double time_s, const PlainFrame& frame, const Loaded* shown)
{
    loader_.request(requestOf(look, time_s, frame, shown));
}

void Reloader::stand(const Look& look, double time_s, const PlainFrame& frame, const Loaded* shown)
{
    loader_.stand(requestOf(look, time_s, frame, shown));
}

void Reloader::measureLost(const Look& look, double time_s, const Loaded& shown)
{
    LoadRequest request;
    request.measuresLost = true;
    request.look = look;
    request.look.view = DataView::lost;
    request.look.methods = {Method{}};
    request.time_s = time_s;
    request.shown = shown.scene->scene;
    loader_.request(std::move(request));
}

void Reloader::tryPrograms(long number, const Loaded& loaded, bool toMeasure)
{
    measuring_ = toMeasure;
    std::vector<ProgramTrial> programs;
    for (const auto& trial : loaded.trials)
        programs.push_back(trial.program);
    trier_.start(number, std::move(programs), device_.drawLimit_s);
}

// From either thread.
void Reloader::tellWatchFault(const Error& error)
{
    const std::lock_guard lock(watchFaultMutex_);
    watchFault_ = error;
}

std::optional<Error> Reloader::takeWatchFault()
{
    const std::lock_guard lock(watchFaultMutex_);
    return std::exchange(watchFault_, std::nullopt);
}

bool Reloader::hasMissedAChange()
{
    return std::exchange(changedMeanwhile_, false);
}

void Reloader::watch(const std::vector<std::filesystem::path>& files, const Loaded* shown)
{
    // What the last good picture came from counts too: an edit of it may be the mend.
    std::set<std::filesystem::path> all(files.begin(), files.end());
    if (shown != nullptr)
        all.insert(shown->files.begin(), shown->files.end());
    try {
        watcher_.watch({all.begin(), all.end()});
    } catch (const Error& error) { // too many watches: the picture is good all the same
        tellWatchFault(error);
    }
}

ReloadOutcome Reloader::outcomeOf(const LoadRequest& request) const
{
    ReloadOutcome outcome;
    outcome.number = request.number;
    outcome.waited_ms =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - request.askedAt).count();
    return outcome;
}

std::optional<ReloadOutcome> Reloader::step(const Loaded* shown)
{
    if (auto outcome = loader_.take())
        if (auto result = heard(std::move(*outcome), shown))
            return result;
    if (const auto reply = trier_.take())
        return tried(*reply);
    return std::nullopt;
}

std::optional<ReloadOutcome> Reloader::heard(LoadOutcome heard, const Loaded* shown)
{
    const LoadRequest& request = heard.request;
    if (request.measuresLost) {
        if (heard.loaded && !trier_.isBusy() && request.number == loader_.latest())
            tryPrograms(request.number, *heard.loaded, true);
        return std::nullopt;
    }
    watch(heard.files, shown);
    // A save between the reading of a file and its first watch.
    if (!heard.stamp.empty() && stampOf(heard.files) != heard.stamp)
        changedMeanwhile_ = true;
    ReloadOutcome outcome = outcomeOf(request);
    if (heard.error) {
        if (request.number != loader_.latest())
            return std::nullopt; // a later one will tell
        trier_.cancel();
        pending_.reset();
        outcome.error = std::move(heard.error);
        return outcome;
    }
    Loaded& loaded = *heard.loaded;
    if (lacksPictures(loaded, shown)) {
        ask(request.look, request.time_s, request.frame, shown);
        return std::nullopt;
    }
    if (shown != nullptr && needsNoCompiler(loaded, *shown)) {
        if (request.number == loader_.latest()) {
            if (!measuring_) // what is measured does no harm, and to end it takes its process
                trier_.cancel();
            pending_.reset();
        }
        outcome.loaded = std::move(loaded);
        return outcome;
    }
    if (lacksTrials(loaded, shown)) { // its program was to be one that is shown no more
        ask(request.look, request.time_s, request.frame, shown);
        return std::nullopt;
    }
    const bool sameTexts =
        pending_ && std::ranges::equal(pending_->drawn, loaded.drawn, {}, &DrawnBy::texts, &DrawnBy::texts);
    if (!sameTexts || !trier_.isBusy())
        tryPrograms(request.number, loaded, false);
    pending_ = std::move(loaded);
    return std::nullopt;
}

std::optional<ReloadOutcome> Reloader::tried(const TrialReply& reply)
{
    if (measuring_) {
        measuring_ = false;
        if (reply.number != loader_.latest())
            return std::nullopt; // of a picture that is shown no more
        ReloadOutcome measured;
        if (reply.fault.empty() && !reply.outcomes.empty())
            measured.lost = reply.outcomes.back().mean;
        return measured.lost ? std::optional(measured) : std::nullopt;
    }
    if (!pending_)
        return std::nullopt;
    ReloadOutcome outcome = outcomeOf(pending_->request);
    outcome.error = errorOf(reply, *pending_);
    if (outcome.error && pending_->plain && pending_->plain->text.checksLoops && reply.fault.empty() &&
        !reply.outcomes.back().messages.empty()) {
        // The check of loops may fail where the shader would not.
        leaveOutLoopCheck(*pending_->plain);
        pending_->trials = {
            {trialOf(*pending_->plain, pending_->plainSettings), pending_->plain->text.text, {}}};
        tryPrograms(reply.number, *pending_, false);
        return std::nullopt;
    }
    for (const auto& each : reply.outcomes) {
        outcome.compile_ms += each.compile_ms;
        outcome.firstDraw_ms += each.firstDraw_ms;
    }
    if (!outcome.error)
        outcome.loaded = std::move(*pending_);
    pending_.reset();
    return outcome;
}

} // namespace dioptre
