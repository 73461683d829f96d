// What `dioptre doctor` finds out, and what it says of it.
#pragma once

#include "command/environment.h"
#include "gl/attempt.h"
#include "gl/limits.h"
#include "render/device_scene.h"
#include "render/exact_arithmetic.h"
#include "render/frame_clock.h"
#include "render/loop_canary.h"
#include "render/probe.h"

#include <string>
#include <vector>

namespace dioptre
{

// Of the device behind the first backend that works. Where floats cannot be drawn into, what follows the
// limits is not measured.
struct DeviceFindings {
    ContextInfo context;
    DeviceLimits limits;
    DriverEnvironment environment;
    FloatSums sums;
    ClockKind clock = ClockKind::finish; // that bench takes here
    Clocks clocks;
    LoopCanary loops;
    ExactArithmetic arithmetic;
};

struct Verdict {
    ExitCode code = ExitCode::done;
    std::string text;
};

// A backend that was tried.
struct Attempt : BackendReport {
    bool asked = true; // else it is only told of, and nothing follows from it
};

// The one that makeContext() takes of those asked for: the first on a graphics card, else the first; null
// where none works.
const Attempt* firstThatWorks(const std::vector<Attempt>& attempts);

Verdict verdictOn(const DeviceFindings& findings); // checkFailed where pictures would come out wrong

// Tables with what follows from them, for people.
std::string backendsText(const std::vector<Attempt>& attempts);
std::string findingsText(const DeviceFindings& findings);
std::string verdictText(const Verdict& verdict);

// One JSON object; `findings` is null where no backend works.
std::string doctorJson(const std::vector<Attempt>& attempts, const DeviceFindings* findings,
                       const Verdict& verdict);

} // namespace dioptre
