#include "live/reload_bench.h"

#include "base/child_process.h"
#include "base/clock.h"
#include "base/statistics.h"
#include "command/progress.h"
#include "live/edited_copy.h"
#include "live/live.h"
#include "live/session.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>

namespace dioptre
{
namespace
{

// Compile through first draw without the driver's cache, medians of `dioptre bench`. Before there is a
// window: the two would share the processor.
double coldStart_ms(const Input& input, const ReloadBenchOptions& options)
{
    const auto outcome =
        runChild({"/proc/self/exe", "bench", input.path.string(), "--size",
                  fmt::format("{}x{}", options.width, options.height), "--frames", "6", "--json"});
    if (!outcome || outcome->code != 0)
        fail(ExitCode::retry, outcome ? outcome->error : "no process can be started", "try again");
    const auto json = nlohmann::json::parse(outcome->out);
    return json["inputs"][0]["compile_through_first_draw_ms"].get<double>();
}

// Shares of 0..1 that no run before this one has had, so that no cache knows them: golden-ratio steps from
// where the clock stands.
class Shares
{
public:
    double next()
    {
        at_ += 0.6180339887498949;
        at_ -= std::floor(at_);
        return at_;
    }

private:
    double at_ =
        static_cast<double>(std::chrono::system_clock::now().time_since_epoch().count() % 1000000007) /
        1000000007.0;
};

// Watches a session from one edit to the next.
class ReloadWatch
{
public:
    ReloadWatch(Session& session, bool running) : session_(session), running_(running) {}

    void settle()
    {
        while (session_.isBusy() || session_.picturesShown() == 0)
            step();
        if (!running_)
            while (!session_.stage().isDone())
                step();
    }

    // The usual time between two frames while the picture runs.
    double usualFrame_ms()
    {
        std::vector<double> frames_ms;
        for (int i = 0; i < 40; ++i)
            frames_ms.push_back(frame_ms());
        return median(frames_ms);
    }

    void edit(const std::function<void()>& save, double usual_ms, ReloadRow& row)
    {
        settle();
        const long shown = session_.picturesShown();
        save();
        Stopwatch watch;
        double longest_ms = 0.0;
        while (session_.picturesShown() == shown) {
            longest_ms = std::max(longest_ms, frame_ms());
            if (session_.model().fault)
                fail(ExitCode::checkFailed, session_.model().fault->text, "this edit should be good");
        }
        const double shown_ms = watch.lap_ms();
        row.shown_ms.push_back(shown_ms);
        row.frames.push_back(shown_ms / usual_ms);
        if (session_.model().reload.compile_ms > 0.0)
            row.compile_ms.push_back(session_.model().reload.compile_ms);
        if (running_)
            row.gap.push_back(longest_ms / usual_ms);
    }

private:
    void step()
    {
        if (running_)
            session_.moveOn();
        if (!session_.turn())
            fail(ExitCode::retry, "the window was closed", "leave it open until the figures are there");
    }

    // Until the next frame.
    double frame_ms()
    {
        const long frames = session_.framesShown();
        Stopwatch watch;
        while (session_.framesShown() == frames && !session_.model().fault)
            step();
        return watch.lap_ms();
    }

    Session& session_;
    bool running_;
};

LiveOptions liveOptions(const ReloadBenchOptions& options, const std::filesystem::path& input,
                        const std::string& pictures)
{
    LiveOptions live;
    live.input = input.string();
    live.width = options.width;
    live.height = options.height;
    live.samples = 4;
    live.forget = true;
    live.hidePanel = true;
    live.included = {pictures};
    return live;
}

} // namespace

ExitCode benchReload(const ReloadBenchOptions& options)
{
    const Input input = findInput(options.input);
    const auto textures = texturesFolder(searchPlaces()).string();
    ReloadResult result;
    result.cold_ms = coldStart_ms(input, options);
    EditedCopy copy(input);
    ::setenv("DIOPTRE_GLSL", copy.glslFolder().c_str(), 1);
    startVariablesAtZero();
    Shares shares;
    const Progress progress = terminalProgress();
    double done = 0.0;
    const auto measure = [&](ReloadRow row, const std::filesystem::path& shown, bool running,
                             const std::function<void(double)>& edit) {
        LiveOptions live = liveOptions(options, shown, textures);
        live.included.push_back(std::filesystem::absolute(input.path).parent_path().string());
        Session session(live);
        result.renderer = session.window().context().renderer;
        ReloadWatch watch(session, running);
        watch.settle();
        if (running && result.frame_ms == 0.0)
            result.frame_ms = watch.usualFrame_ms();
        for (int i = 0; i < options.edits; ++i) {
            watch.edit([&] { edit(shares.next()); }, result.frame_ms, row);
            if (progress)
                progress((done += 1.0) / (5.0 * options.edits));
        }
        result.rows.push_back(std::move(row));
    };
    const auto value = [&](double share) { copy.editValue(share); };
    const auto trivial = [&](double share) { copy.editTrivial(share); };
    const auto tracer = [&](double share) { copy.editTracer(share); };
    measure({"a value, while it runs", {}, {}, {}, {}}, copy.scene(), true, value);
    measure({"the tracer, while it runs", {}, {}, {}, {}}, copy.scene(), true, tracer);
    measure({"a value", {}, {}, {}, {}}, copy.scene(), false, value);
    measure({"the tracer", {}, {}, {}, {}}, copy.scene(), false, tracer);
    measure({"a trivial shader", {}, {}, {}, {}}, copy.shader(), false, trivial);
    fmt::print("{}", options.json ? reloadJson(result, options) : reloadText(result, options));
    return ExitCode::done;
}

} // namespace dioptre
