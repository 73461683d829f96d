#include "command/plain_tracer.h"

#include "base/child_process.h"
#include "base/error.h"
#include "command/figures.h"
#include "command/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr double drawnPixels = 2500.0; // seconds in place of minutes; every n-th pixel of every n-th row

std::string lastLine(std::string text)
{
    while (text.ends_with('\n'))
        text.pop_back();
    return text.substr(text.rfind('\n') + 1);
}

} // namespace

PlainTracer runPlainTracer(const BenchInput& input, const BenchOptions& options)
{
    const auto script = glslFolder().parent_path() / "host" / "command" / "plain_tracer.py";
    if (!std::filesystem::is_regular_file(script))
        fail(ExitCode::inputMissing, {script.string()}, "there is no plain tracer for --python",
             "take it from dioptre's sources, or leave --python out");
    const double pixels = static_cast<double>(options.width) * options.height;
    const int stride = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels / drawnPixels))));
    const auto outcome =
        runChild({"python3", script.string(), input.file.string(), std::to_string(options.width),
                  std::to_string(options.height), std::to_string(stride)});
    if (!outcome)
        fail(ExitCode::toolMissing, "--python needs python3, which cannot be started",
             "install the package python3, or leave --python out");
    const auto numbers = numbersIn(outcome->out, {"pixels", "seconds", "scaled_seconds"});
    if (outcome->code != 0 || outcome->signal != 0 || !numbers)
        fail(ExitCode::badInput, {input.file.string()},
             fmt::format("the plain Python tracer does not draw it ({})", lastLine(outcome->error)),
             "put another scene first, or leave --python out");
    return {input.file.stem().string(), std::lround(numbers->at(0)), 1e3 * numbers->at(1),
            1e3 * numbers->at(2) * options.samples.value_or(1)};
}

} // namespace dioptre
