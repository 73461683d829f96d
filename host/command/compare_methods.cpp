#include "command/compare_methods.h"

#include "base/file.h"
#include "base/interruption.h"
#include "base/lettering.h"
#include "base/picture_stack.h"
#include "command/display_option.h"
#include "command/input.h"
#include "command/method_drawing.h"
#include "command/progress.h"
#include "metric/ssim.h"
#include "render/interleave.h"
#include "render/still.h"
#include "scene/load.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

constexpr double budgetAMethod_ms = 3000.0;

// Throws usage.
std::vector<Method> methodsOf(const CompareOptions& options)
{
    std::vector<Method> methods;
    for (const auto& name : options.methods) {
        methods.push_back(methodNamed(name));
        if (std::ranges::count(methods, methods.back()) > 1)
            fail(ExitCode::usage, fmt::format("--methods names {} twice", nameOf(methods.back())),
                 "name each method once");
    }
    return methods;
}

void refuseBadMethods(const CompareOptions& options, std::size_t methods)
{
    if (methods < 2)
        fail(ExitCode::usage, "--methods names one method, and there is nothing to hold it to",
             "name several, as in --methods trace,flat:16,phong:64");
    if (!options.picture.empty())
        fail(ExitCode::usage, "--methods draws one scene, and two inputs are named",
             "leave " + options.picture + " out, or leave --methods out to compare two pictures");
    if ((options.wipe || options.difference) && methods != 2)
        fail(ExitCode::usage,
             fmt::format("{} is of two methods, and --methods names {}",
                         options.wipe ? "--wipe" : "--difference", methods),
             "name two, or leave it out for a sheet of all");
    if (options.wipe && options.difference)
        fail(ExitCode::usage, "--wipe and --difference ask for two pictures", "leave one of them out");
    if (options.wipe && !(*options.wipe >= 0.0 && *options.wipe <= 1.0))
        fail(ExitCode::usage, fmt::format("--wipe {} is no share of the picture", *options.wipe),
             "give a number from 0 to 1");
    if (options.pixelsPerDegree != usualPixelsPerDegree)
        fail(ExitCode::usage, "--ppd is of FLIP, which --methods does not measure", "leave it out");
    if (options.exposure && !(std::abs(*options.exposure) <= 100.0))
        fail(ExitCode::usage, fmt::format("--exposure {} is out of reach", *options.exposure),
             "give a number of stops from -100 to 100");
    if (!(std::abs(options.time_s) <= static_cast<double>(std::numeric_limits<float>::max())))
        fail(ExitCode::usage, fmt::format("--time {} is no moment", options.time_s),
             "give a number of seconds that a 32-bit float can hold");
    if (options.output.empty() && (options.wipe || options.difference))
        fail(ExitCode::usage, "--wipe and --difference draw a picture, and no file is named for it",
             "name one with -o FILE.png");
    if (!options.output.empty() && storedKindNamed(options.output) != StoredKind::png)
        fail(ExitCode::usage, "-o " + options.output + " is no .png", "name the picture FILE.png");
}

// The largest difference of a channel, of every pixel; 0 where it is not finite, which is told apart.
std::vector<float> differencesOf(const PicturePair& pair)
{
    std::vector<float> differences;
    for (std::size_t i = 0; i < pair.judged.size(); ++i) {
        const glm::vec3 d = glm::abs(pair.picture[i] - pair.reference[i]);
        differences.push_back(pair.judged[i] != 0 ? std::max({d.r, d.g, d.b}) : 0.0F);
    }
    return differences;
}

void judge(MethodRow& row, const Picture& reference, const Display& display)
{
    const PicturePair pair = pairOf(reference, row.picture);
    row.linear = linearError(pair);
    row.ssim = ssim(encoded(displayed(pair, display, display)));
    row.differences = differencesOf(pair);
}

// 1, 2 or 5 times a power of ten, that nearly all differences stay below: single pixels at edges may be
// brighter than what a class is to see.
double scaleOf(const std::vector<MethodRow>& rows)
{
    double most = 0.0;
    for (const auto& row : rows) {
        std::vector<float> sorted = row.differences;
        const auto at =
            sorted.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(sorted.size()));
        std::nth_element(sorted.begin(), at, sorted.end());
        const auto largest = row.linear.max / 20.0; // of what few pixels show
        most = std::max({most, static_cast<double>(*at), largest});
    }
    if (most <= 0.0)
        return 1.0;
    const double power = std::pow(10.0, std::floor(std::log10(most)));
    for (const double step : {1.0, 2.0, 5.0})
        if (step * power >= most)
            return step * power;
    return 10.0 * power;
}

// All in one context, and one after the other in every round.
void drawAll(const CompareOptions& options, const Scene& scene, const std::vector<Method>& methods,
             MethodsResult& result)
{
    const ViewSettings view{options.width, options.height, options.samples, glslFolder(), pictureCache()};
    const auto context = makeContext(options.backend);
    result.context = context->info();
    std::vector<MethodDrawing> made;
    std::vector<Drawing*> drawings;
    for (const auto& method : methods) {
        made.push_back(methodDrawing(scene, view, method, result.context));
        drawings.push_back(made.back().drawing.get());
        Interruption::check();
    }
    FrameClock clock(clockFor(result.context));
    Rounds rounds;
    rounds.warmUp = 1;
    rounds.budget_ms = budgetAMethod_ms * static_cast<double>(methods.size());
    const auto tell = terminalProgress();
    const auto times_ms = timeInterleaved(drawings, clock, rounds, [&](double share) {
        Interruption::check();
        if (tell)
            tell(share);
    });
    for (std::size_t i = 0; i < methods.size(); ++i) {
        Still still = drawStill(*drawings[i], {0, 0, view.width, view.height});
        result.rows.push_back({methods[i],
                               std::move(still.picture),
                               times_ms[i],
                               drawings[i]->times(),
                               drawings[i]->facts(),
                               still.counts.nonfinite,
                               {},
                               1.0,
                               {}});
    }
}

MethodsResult measured(const CompareOptions& options, const std::vector<Method>& methods)
{
    const Input input = findInput(options.reference);
    if (input.plainShader)
        fail(ExitCode::usage, options.reference + " is a plain shader, and --methods is for scenes",
             "name a scene");
    const Scene scene =
        loadScene(input.path, options.overrides, options.time_s, searchPlaces(options.included));
    if (!options.output.empty())
        Lettering(11); // a font that is missing is told before long work
    MethodsResult result;
    result.scene = scene.title.empty() ? input.name : scene.title;
    result.display = displayAsked(scene.output, options.exposure, options.curve);
    drawAll(options, scene, methods, result);
    for (auto& row : result.rows)
        judge(row, result.rows.front().picture, result.display);
    result.scale = scaleOf(result.rows);
    return result;
}

} // namespace

ExitCode compareMethods(const CompareOptions& options)
{
    const std::vector<Method> methods = methodsOf(options);
    refuseBadMethods(options, methods.size());
    if (!options.output.empty())
        PendingFile{options.output}; // a folder that cannot be written to is refused before anything is drawn
    MethodsResult result;
    if (const int signal = signalDuring([&] {
            result = measured(options, methods);
            if (!options.output.empty())
                writePng(options.output, methodsPicture(options, result), {},
                         {{"Software", std::string("dioptre ") + DIOPTRE_VERSION},
                          {"dioptre.input", options.reference},
                          {"dioptre.methods", fmt::format("{}", fmt::join(options.methods, ","))}});
        });
        signal != 0) {
        fmt::print(stderr, "dioptre: stopped by a signal, and nothing was written\n");
        endBySignal(signal);
    }
    fmt::print("{}", options.json ? methodsJson(options, result) : methodsText(options, result));
    return ExitCode::done;
}

} // namespace dioptre
