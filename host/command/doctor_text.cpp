#include "command/doctor.h"

#include "base/text.h"
#include "render/samples.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

struct Section {
    std::string title;
    std::vector<std::pair<std::string, std::string>> rows;
    std::vector<std::string> follows; // sentences
};

std::string textOf(const Section& section)
{
    std::string text = section.title + "\n";
    for (const auto& [name, value] : section.rows)
        text += fmt::format("  {:28}  {}\n", name, value);
    for (const std::string& sentence : section.follows)
        text += fmt::format("  => {}\n", sentence);
    return text + "\n";
}

std::string yesNo(bool yes)
{
    return yes ? "yes" : "no";
}

std::string side(int pixels)
{
    return fmt::format("{} px", pixels);
}

Section limitsSection(const ContextInfo& context, const DeviceLimits& limits)
{
    const BlockCapacity capacity = capacityOf(static_cast<std::size_t>(limits.uniformBlock_bytes));
    return {
        "device: " + context.renderer,
        {{"kind", context.software ? "software, the CPU draws" : "not known as software"},
         {"texture side", side(limits.textureSide_px)},
         {"viewport", fmt::format("{} x {} px", limits.viewportWidth_px, limits.viewportHeight_px)},
         {"array texture layers", std::to_string(limits.arrayLayers)},
         {"uniform block", fmt::format("{} bytes", limits.uniformBlock_bytes)},
         {"fragment uniform blocks", std::to_string(limits.fragmentUniformBlocks)},
         {"fragment uniform components", std::to_string(limits.fragmentUniformComponents)},
         {"fragment texture units", std::to_string(limits.fragmentTextureUnits)},
         {"float32 target", yesNo(limits.drawsIntoFloat)},
         {"GL_ARB_gpu_shader5", yesNo(limits.gpuShader5)}},
        {fmt::format("pictures up to {} pixels on a side", limits.pictureSide_px),
         fmt::format("scenes of up to {} materials and {} lights, and {} objects under trace.form = \"loop\"",
                     capacity.materials, capacity.lights, capacity.tableObjects)}};
}

Section sumsSection(const FloatSums& sums)
{
    return {"float target",
            {{"three draws added", fmt::format("off by {:.2g} units in the last place", sums.worst_ulp)}},
            {sums.right ? "samples add up in float32 over any number of draws"
                        : "samples do not add up: pictures of several draws are wrong"}};
}

Section clockSection(const Clocks& clocks, ClockKind chosen)
{
    Section section{"clock",
                    {{"one draw until glFinish", fmt::format("{:.1f} ms", clocks.finish_ms)},
                     {"the same by timer query", fmt::format("{:.1f} ms", clocks.timerQuery_ms)}},
                    {"bench times draws by " + nameOf(chosen)}};
    if (chosen == ClockKind::timerQuery && !clocks.queriesHold())
        section.follows.emplace_back("they tell less than half of the time that passed: do not believe them");
    return section;
}

std::string sharedBy(const LoopCanary& loops)
{
    std::vector<std::string> sharers;
    if (loops.sharedByLoops())
        sharers.emplace_back("all loops of a pixel");
    if (loops.sharedByNeighbours())
        sharers.emplace_back("its neighbours");
    return sharers.empty() ? "each loop by itself" : "shared by " + join(sharers, " and ");
}

Section loopsSection(const LoopCanary& loops, bool software)
{
    Section section{"loops",
                    {{fmt::format("one of {} iterations", loops.asked), fmt::format("ran {}", loops.ran)},
                     {fmt::format("two of {}", loops.askedOfTwo),
                      fmt::format("ran {} and {}", loops.ranOfTwo[0], loops.ranOfTwo[1])},
                     {fmt::format("8 pixels in turn, {} each", loops.askedOfNeighbours),
                      fmt::format("the least ran {}", loops.ranOfNeighbours)}},
                    {}};
    if (!loops.faithful)
        section.follows = {"loops do not compute what they should: pictures are wrong"};
    else if (!loops.capped())
        section.follows = {"loops run as long as they are asked to"};
    else
        section.follows = {
            fmt::format("loops end silently after {} iterations, {}", loops.ran, sharedBy(loops))};
    section.follows.push_back(
        fmt::format("a draw takes as many samples as fit in {} iterations, or one", iterationsPerDraw));
    if (software)
        section.follows.push_back(fmt::format("refused: scenes of which one sample can take more than {} (by "
                                              "budget, lights or, under trace.form = \"loop\", objects)",
                                              softwareLoopCap));
    return section;
}

std::string wrongOf(const Tally& tally)
{
    return tally.tested == 0 ? "not there" : fmt::format("{} wrong of {}", tally.wrong, tally.tested);
}

Section arithmeticSection(const ExactArithmetic& arithmetic)
{
    const Guard guard = guardOf(arithmetic);
    const Tally& fma = arithmetic.fma;
    return {"exact arithmetic",
            {{"two-sum as written", wrongOf(arithmetic.plain.twoSum)},
             {"two-sum with precise", wrongOf(arithmetic.precise.twoSum)},
             {"two-sum with a uniform 1", wrongOf(arithmetic.unit.twoSum)},
             {"two-product as written", wrongOf(arithmetic.plain.twoProduct)},
             {"two-product with precise", wrongOf(arithmetic.precise.twoProduct)},
             {"two-product with a uniform 1", wrongOf(arithmetic.unit.twoProduct)},
             {"two-product by fma()", wrongOf(fma) + (fma.wrong > 0 ? ": not fused"
                                                      : fma.right() ? ": fused"
                                                                    : "")}},
            {guard == Guard::precise ? "compensated kernels will use precise"
             : guard == Guard::unit
                 ? "compensated kernels will use a uniform that holds 1"
                 : "compensated kernels are off: nothing keeps their sums from being regrouped"}};
}

Section extremesSection(const Extremes& extremes)
{
    Section section{"numbers at the edges",
                    {{"normalize() of length 1e20", fmt::format("length {:g}", extremes.normalizeLarge)},
                     {"normalize() of length 1e-20", fmt::format("length {:g}", extremes.normalizeSmall)},
                     {"atan(0, 0)", fmt::format("{:g}", extremes.atanOfZeros)},
                     {"pow(0, 0)", fmt::format("{:g}", extremes.powOfZeros)},
                     {"subnormal results", extremes.subnormalResults ? "kept" : "become 0"},
                     {"subnormal operands", extremes.subnormalOperands ? "kept" : "become 0"}},
                    {}};
    if (extremes.normalizeLarge != 1.0F || extremes.normalizeSmall != 1.0F)
        section.follows.emplace_back(
            "normalize() squares lengths: only those from 1e-18 to 1e18 keep their direction");
    if (!extremes.subnormalResults || !extremes.subnormalOperands)
        section.follows.emplace_back("numbers below 1.2e-38 count as 0");
    section.follows.emplace_back(
        "atan(0, 0) and pow(0, 0) differ between drivers: kernels must not ask for them");
    return section;
}

Section timesSection(const DriverEnvironment& environment, bool software)
{
    Section section{"what explains times",
                    {{"driver's shader cache", environment.shaderCache + ", " + environment.cacheReason},
                     {"cores", std::to_string(environment.cores)}},
                    {}};
    if (environment.shaderCache == "on")
        section.follows.emplace_back("a shader seen before skips the compiler: "
                                     "MESA_SHADER_CACHE_DISABLE=true shows what compiling costs");
    if (!software)
        return section;
    section.rows.emplace_back("rasteriser threads", environment.rasterThreads > 0
                                                        ? std::to_string(environment.rasterThreads)
                                                        : "none, the program's own draws");
    section.rows.emplace_back("LP_NUM_THREADS",
                              environment.threadsAsked.empty() ? "not set" : environment.threadsAsked);
    if (std::max(1, environment.rasterThreads) < environment.cores)
        section.follows.emplace_back("not all cores draw: see LP_NUM_THREADS");
    return section;
}

} // namespace

std::string backendsText(const std::vector<Attempt>& attempts)
{
    Section section{"backends", {}, {}};
    const Attempt* first = firstThatWorks(attempts);
    for (const Attempt& attempt : attempts) {
        const ContextInfo& info = attempt.info;
        if (attempt.fault.empty()) {
            section.rows.emplace_back(info.backend, fmt::format("works: context in {:.0f} ms, {}",
                                                                attempt.start_ms, info.renderer));
            section.rows.emplace_back("", fmt::format("OpenGL {}, GLSL {}", info.version, info.glslVersion));
        } else {
            section.rows.emplace_back(info.backend,
                                      (attempt.absent ? "not here: " : "fails: ") + attempt.fault);
        }
        if (attempt.endedProcess)
            section.follows.push_back(
                fmt::format("trying {} ends dioptre: name another --backend", info.backend));
    }
    if (first != nullptr)
        section.follows.push_back("examined below: " + first->info.backend + ", the first that works");
    return textOf(section);
}

std::string findingsText(const DeviceFindings& findings)
{
    const bool software = findings.context.software;
    std::string text = textOf(limitsSection(findings.context, findings.limits));
    if (findings.limits.drawsIntoFloat)
        text += textOf(sumsSection(findings.sums)) + textOf(loopsSection(findings.loops, software)) +
                textOf(arithmeticSection(findings.arithmetic)) +
                textOf(extremesSection(findings.arithmetic.extremes)) +
                textOf(clockSection(findings.clocks, findings.clock));
    return text + textOf(timesSection(findings.environment, software));
}

std::string verdictText(const Verdict& verdict)
{
    return "verdict: " + verdict.text + "\n";
}

} // namespace dioptre
