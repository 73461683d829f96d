#include "command/doctor.h"

#include "base/text.h"
#include "command/command.h"
#include "command/input.h"
#include "render/samples.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>

namespace dioptre
{
namespace
{

DeviceFindings examine(const ContextInfo& context)
{
    const auto glsl = glslFolder();
    DeviceFindings findings;
    findings.context = context;
    findings.limits = deviceLimits();
    findings.environment = driverEnvironment(context);
    if (findings.limits.drawsIntoFloat) {
        findings.sums = probeFloatSums(glsl);
        findings.clock = clockFor(context);
        findings.clocks = probeClocks(glsl);
        findings.loops = measureLoops(glsl);
        findings.arithmetic = testExactArithmetic(glsl, findings.limits.gpuShader5);
    }
    return findings;
}

} // namespace

const BackendReport* firstThatWorks(const std::vector<BackendReport>& attempts)
{
    const auto works = [](const BackendReport& attempt) { return attempt.fault.empty(); };
    const auto onCard = [&](const BackendReport& attempt) {
        return works(attempt) && !attempt.info.software;
    };
    auto found = std::ranges::find_if(attempts, onCard);
    if (found == attempts.end())
        found = std::ranges::find_if(attempts, works);
    return found != attempts.end() ? &*found : nullptr;
}

Verdict verdictOn(const DeviceFindings& findings)
{
    if (!findings.limits.drawsIntoFloat)
        return {ExitCode::noOpenGl, "no picture can be drawn here: float32 textures cannot be drawn into"};
    std::vector<std::string> faults;
    if (!findings.sums.right)
        faults.push_back(
            fmt::format("samples do not add up in float32 (off by {:.3g} units in the last place)",
                        findings.sums.worst_ulp));
    if (!findings.loops.faithful)
        faults.emplace_back("loops do not compute what they should");
    else if (!loopsSuffice(findings.loops, findings.context.software))
        faults.push_back(fmt::format("loops end silently after {} iterations, and {}", findings.loops.ran,
                                     findings.context.software
                                         ? fmt::format("dioptre counts on {}", softwareLoopCap)
                                         : "dioptre takes this driver for one that does not end them"));
    if (!faults.empty())
        return {ExitCode::checkFailed, "pictures drawn here may be wrong: " + join(faults, "; ")};
    return {ExitCode::done, "pictures can be drawn here; no check that they rely on failed"};
}

ExitCode doctor(const DoctorOptions& options)
{
    std::vector<BackendReport> attempts;
    for (const std::string& backend : backendChoice(options.backend).tries)
        attempts.push_back(tryBackend(backend));
    if (!options.json) {
        fmt::print("{}", backendsText(attempts));
        std::fflush(stdout); // stays where a check below ends the process
    }
    Verdict verdict{ExitCode::noOpenGl, fmt::format("no OpenGL 3.3 here: {}", packagesForOpenGl)};
    std::optional<DeviceFindings> findings;
    if (const BackendReport* first = firstThatWorks(attempts)) {
        const auto context = makeContext(first->info.backend); // by its name: those before it may crash
        findings = examine(context->info());
        verdict = verdictOn(*findings);
    }
    if (options.json)
        fmt::print("{}", doctorJson(attempts, findings ? &*findings : nullptr, verdict));
    else
        fmt::print("{}{}", findings ? findingsText(*findings) : "", verdictText(verdict));
    return verdict.code;
}

} // namespace dioptre
