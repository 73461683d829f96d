// All that a user has changed in a window, and what is to be said to them.
#pragma once

#include "command/command.h"
#include "live/fault.h"
#include "live/live_clock.h"
#include "live/loaded.h"
#include "live/method_choice.h"

#include <map>
#include <optional>
#include <string>

namespace dioptre
{

// What the last reload took, milliseconds.
struct ReloadFigures {
    double load_ms = 0.0;
    double compile_ms = 0.0;   // by the helper, with the first draw; 0 where nothing was compiled
    double window_ms = 0.0;    // making it in the window
    double total_ms = 0.0;     // since it was asked for
    bool keptByDriver = false; // the driver had kept what the helper compiled
};

struct LiveModel {
    explicit LiveModel(const LiveOptions& options)
        : methods(methodChoice(options)), clock(options.time_s, options.paused),
          restartOnReload(options.restart)
    {
    }

    Look look;
    std::vector<std::string> given;             // --set, beneath `changes`
    std::map<std::string, std::string> changes; // of a scene: values in TOML by path
    std::optional<Display> display;             // of a scene, once changed
    MethodChoice methods;                       // of a scene
    PlainFrame frame;                           // of a plain shader
    LiveClock clock;
    bool restartOnReload = false;
    bool showPanel = true;
    bool showHelp = false;

    std::optional<Fault> fault; // of the latest edit: the picture is stale
    std::string notice;         // shown for a while
    ReloadFigures reload;
    std::array<double, 4> lost{}; // by a small picture of the view: cut-off, pool, budget
};

// A plain shader's uniform as it is fed now; `none` where nothing feeds it.
std::vector<double> sliderOf(const LiveModel& model, const Loaded& loaded, const std::string& name,
                             const std::vector<double>& none);

// The scene's camera as it is seen now, or that of a plain shader's uniforms.
Camera cameraOf(const LiveModel& model, const Loaded& loaded);

// "trace.budget" of "trace.budget=8".
std::string pathOf(const std::string& pathAndValue);

// What was changed by hand and is in the file by now: a --set of it is to come back no more.
void forgetGiven(LiveModel& model, const std::string& path);

// Whether a --set is about a part of that value, or about a whole that it is part of.
bool isOverGiven(const LiveModel& model, const std::string& path);

// The look with its changes as --set takes them.
Look wanted(const LiveModel& model);

} // namespace dioptre
