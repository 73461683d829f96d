#include "command/stability_batch.h"

#include "base/file.h"
#include "base/write_file.h"
#include "command/stability_device.h"
#include "gl/context.h"
#include "stability/batch_csv.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

namespace dioptre
{

ExitCode runBatch(const StabilityOptions& options)
{
    const auto problems = readBatch(readFile(options.input), options.input);
    std::optional<Variant> variant;
    if (const auto named = std::ranges::find(variantNames, options.variant, &VariantName::name);
        named != variantNames.end())
        variant = named->variant;
    const auto context = makeContext(options.backend);
    const auto answers = runKernels(kernelDeviceHere(), problems, variant, Frame::ofRay);
    const std::string text = batchText(problems, answers);
    if (options.output.empty())
        std::fwrite(text.data(), 1, text.size(), stdout);
    else
        writeFile(options.output, text);
    const auto hits = std::ranges::count_if(answers, [](const auto& answer) { return answer.hit; });
    fmt::print(stderr, "{}: {} rays, {} hits, on {}\n", options.input, answers.size(), hits,
               context->info().renderer);
    return ExitCode::done;
}

} // namespace dioptre
