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

// "auto" asks for none in particular: single ones that it does not stand for are told of, too.
std::vector<Attempt> tryBackends(const std::string& backend)
{
    const std::vector<std::string>& asked = backendChoice(backend).tries;
    std::vector<Attempt> attempts;
    for (const std::string& name : asked)
        attempts.push_back({tryBackend(name)});
    for (const BackendChoice& choice : backendChoices())
        if (backend == "auto" && choice.tries == std::vector{choice.name} &&
            std::ranges::find(asked, choice.name) == asked.end())
            attempts.push_back({tryBackend(choice.name), false});
    return attempts;
}

Verdict verdictWithoutContext(const std::vector<Attempt>& attempts)
{
    const auto found =
        std::ranges::find_if(attempts, [](const Attempt& attempt) { return attempt.fault.empty(); });
    const std::string mend =
        found == attempts.end()
            ? attempts.front().mend
            : fmt::format("name --backend {}, or {}", found->info.backend, attempts.front().mend);
    return {ExitCode::noOpenGl, "no OpenGL 3.3 here: " + mend};
}

} // namespace

const Attempt* firstThatWorks(const std::vector<Attempt>& attempts)
{
    const auto works = [](const Attempt& attempt) { return attempt.asked && attempt.fault.empty(); };
    const auto onCard = [&](const Attempt& attempt) { return works(attempt) && !attempt.info.software; };
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
    const std::vector<Attempt> attempts = tryBackends(options.backend);
    if (!options.json) {
        fmt::print("{}", backendsText(attempts));
        std::fflush(stdout); // stays where a check below ends the process
    }
    Verdict verdict = verdictWithoutContext(attempts);
    std::optional<DeviceFindings> findings;
    if (const Attempt* first = firstThatWorks(attempts)) {
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
