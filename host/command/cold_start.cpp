#include "command/cold_start.h"

#include "base/child_process.h"
#include "base/statistics.h"
#include "command/figures.h"
#include "command/input.h"
#include "render/plain.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdio>

namespace dioptre
{
namespace
{

// Mesa by its new and its old name, and NVIDIA.
const std::map<std::string, std::string> withoutDiskCache{{"MESA_SHADER_CACHE_DISABLE", "true"},
                                                          {"MESA_GLSL_CACHE_DISABLE", "true"},
                                                          {"__GL_SHADER_DISK_CACHE", "0"}};

// The child's own message, without the name that main() puts before it and what drivers print.
std::string messageIn(const std::string& error)
{
    const std::string prefix = "dioptre: ";
    const std::size_t start = error.starts_with(prefix) ? 0 : error.find("\n" + prefix);
    if (start == std::string::npos)
        return "";
    std::string message = error.substr(error.find(prefix, start) + prefix.size());
    while (message.ends_with('\n'))
        message.pop_back();
    return message;
}

[[noreturn]] void failAs(const ChildOutcome& outcome, const std::string& name)
{
    const std::string message = messageIn(outcome.error);
    if (outcome.signal == 0 && outcome.code != 0 && !message.empty())
        throw Error(static_cast<ExitCode>(outcome.code), message);
    const std::string end =
        outcome.signal != 0 ? fmt::format("signal {}", outcome.signal) : fmt::format("code {}", outcome.code);
    fail(ExitCode::retry, fmt::format("{}: the process that starts it cold ended with {}", name, end),
         "try again, with a smaller --size if memory is short");
}

void startOnce(const BenchInput& input, const BenchOptions& options, BenchRow& row)
{
    const std::string size = fmt::format("{}x{}", options.width, options.height);
    std::vector<std::string> command{"/proc/self/exe",
                                     "bench",
                                     "--cold-start",
                                     "--size",
                                     size,
                                     "--spp",
                                     std::to_string(options.samples.value_or(1)),
                                     "--backend",
                                     options.backend};
    if (!input.plainShader)
        command.insert(command.end(), {"--method", nameOf(input.method)});
    for (const auto& folder : options.included)
        command.insert(command.end(), {"--include", folder});
    command.insert(command.end(), {"--", input.name});
    const auto outcome = runChild(command, withoutDiskCache);
    if (!outcome)
        fail(ExitCode::retry, "the program cannot start itself again",
             "see whether memory or processes are short");
    const auto numbers = numbersIn(outcome->out, {"compile_ms", "first_draw_ms"});
    if (outcome->code != 0 || outcome->signal != 0 || !numbers)
        failAs(*outcome, input.name);
    row.compile_ms.push_back(numbers->front());
    row.firstDraw_ms.push_back(numbers->back());
    row.ready_ms.push_back(numbers->front() + numbers->back());
    row.peak_mib.push_back(outcome->peak_mib);
}

} // namespace

ExitCode startCold(const BenchInput& input, const BenchOptions& options)
{
    const ViewSettings view{options.width, options.height, options.samples.value_or(1), glslFolder()};
    if (input.plainShader)
        startVariablesAtZero();
    const auto context = makeContext(options.backend);
    const MethodDrawing made = drawingOf(input, view, context->info());
    made.drawing->draw(); // for the peak memory
    const nlohmann::json json = {{"compile_ms", made.drawing->times().compile},
                                 {"first_draw_ms", made.drawing->times().firstDraw}};
    fmt::print("{}\n", json.dump());
    return ExitCode::done;
}

void measureColdStarts(const std::vector<BenchInput>& inputs, const BenchOptions& options,
                       std::vector<BenchRow>& rows, const std::function<void(double)>& progress)
{
    const auto rounds = static_cast<std::size_t>(options.coldStarts);
    double done = 0.0;
    for (std::size_t round = 0; round < rounds; ++round) {
        for (const std::size_t i : roundOrder(inputs.size(), round)) {
            startOnce(inputs[i], options, rows[i]);
            if (progress)
                progress(++done / static_cast<double>(rounds * inputs.size()));
        }
    }
}

} // namespace dioptre
