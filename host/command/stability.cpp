#include "command/stability.h"

#include "command/stability_batch.h"
#include "command/stability_device.h"
#include "command/stability_report.h"
#include "command/stability_scales.h"
#include "gl/context.h"
#include "stability/kernel_run.h"

#include <algorithm>

namespace dioptre
{
namespace
{

std::vector<std::string_view> casesOf(const StabilityOptions& options)
{
    std::vector<std::string_view> names;
    for (const auto& name : options.cases)
        names.push_back(caseRow(name).name);
    if (names.empty())
        for (const CaseRow& row : caseRows())
            names.push_back(row.name);
    return names;
}

StabilityResult run(const KernelDevice& device, const CaseRow& row, const StabilityOptions& options)
{
    const auto count = std::min(row.rays, static_cast<std::size_t>(options.rays));
    const auto problems = problemsOf(row.name, options.seed, count);
    const auto truth = answersOf(problems);
    const auto figures = [&](std::optional<Variant> variant) {
        return measureCase(row, problems, truth, runKernels(device, problems, variant, Frame::given));
    };
    StabilityResult result{&row, figures(std::nullopt), {}, figures(Variant::textbook), {}};
    result.verdict = judgeCase(row, result.figures);
    result.textbookVerdict = judgeCase(row, result.textbook);
    return result;
}

} // namespace

ExitCode stability(const StabilityOptions& options)
{
    const auto names = casesOf(options); // a wrong name is told before anything runs
    if (!options.input.empty())
        return runBatch(options);
    const auto context = makeContext(options.backend);
    const KernelDevice device = kernelDeviceHere();
    std::vector<StabilityResult> results;
    for (const auto name : names) {
        results.push_back(run(device, caseRow(name), options));
        if (!options.json)
            printRow(results.back(), results.size() == 1);
    }
    if (!options.plot.empty())
        writeScalePlot(device, options);
    report(options, context->info(), results);
    const bool pass = std::ranges::all_of(results, [](const auto& result) { return result.verdict.pass; });
    return pass ? ExitCode::done : ExitCode::checkFailed;
}

} // namespace dioptre
