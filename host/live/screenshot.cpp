#include "live/screenshot.h"

#include "live/camera_control.h"
#include "live/panel_output_rows.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace dioptre
{
namespace
{

// "[0.5, 1]", as --set takes a uniform's numbers.
std::string listOf(const std::vector<double>& numbers)
{
    std::string list;
    for (const double number : numbers)
        list += fmt::format("{}{}", list.empty() ? "" : ", ", number);
    return numbers.size() == 1 ? list : "[" + list + "]";
}

} // namespace

std::filesystem::path freeName(const std::filesystem::path& pattern)
{
    for (int number = 1;; ++number) {
        const auto name = pattern.parent_path() / fmt::format("{}-{}{}", pattern.stem().string(), number,
                                                              pattern.extension().string());
        std::error_code unknown; // whoever writes it is told
        if (!std::filesystem::exists(name, unknown))
            return name;
    }
}

std::vector<std::string> valuesShown(const LiveModel& model, const Loaded& loaded,
                                     const std::vector<std::string>& read)
{
    std::vector<std::string> values = wanted(model).overrides;
    if (const auto encode = model.look.values.find("u_encode"); encode != model.look.values.end())
        values.push_back("u_encode=" + encode->second);
    if (model.look.camera)
        for (const auto& value : overridesOf(*model.look.camera))
            values.push_back(value);
    if (model.display && loaded.scene)
        for (const auto& value : overridesOf(*model.display, loaded.scene->scene->output))
            values.push_back(value);
    if (!loaded.plain)
        return values;
    // Sliders, and what keys and mouse move.
    for (const auto& [name, numbers] : hostUniforms(model.frame, 1, 1, {}))
        if (const auto start = loaded.sliders.find(name); start != loaded.sliders.end() &&
                                                          start->second != numbers &&
                                                          std::ranges::find(read, name) != read.end())
            values.push_back(name + "=" + listOf(numbers));
    return values;
}

std::vector<std::string> renderWords(const LiveModel& model, const Loaded& loaded,
                                     const std::vector<std::string>& read, const std::string& size,
                                     const std::filesystem::path& file)
{
    const Look& look = model.look;
    std::vector<std::string> words{"render", look.input.path.string(),
                                   "-o",     file.string(),
                                   "--size", size,
                                   "--time", fmt::format("{}", model.clock.time_s())};
    if (loaded.scene)
        words.insert(words.end(), {"--spp", std::to_string(look.samples)});
    if (const Method method = methodInFull(model.methods); loaded.scene && isRasterised(method))
        words.insert(words.end(), {"--method", nameOf(method)});
    if (look.view != DataView::none)
        words.insert(words.end(), {"--view", std::string(rowOf(look.view).name)});
    for (const auto& value : valuesShown(model, loaded, read))
        words.insert(words.end(), {"--set", value});
    for (const auto& folder : look.places.included)
        words.insert(words.end(), {"--include", folder.string()});
    for (std::size_t i = 0; i < look.channels.size(); ++i)
        if (!look.channels[i].empty())
            words.insert(words.end(), {fmt::format("--channel{}", i), look.channels[i]});
    return words;
}

std::string whatShotLacks(const MethodChoice& methods)
{
    const bool both = methods.comparison == Comparison::split || methods.comparison == Comparison::difference;
    const bool edges = methods.wires && isRasterised(methodInFull(methods));
    return std::string(both ? ", of " + nameOf(methodInFull(methods)) + " alone" : "") +
           (edges ? ", without edges" : "");
}

ScreenshotJob::ScreenshotJob(std::vector<std::string> words, const std::filesystem::path& file) : file_(file)
{
    words.insert(words.begin(), "/proc/self/exe");
    child_ = FedChild::start(words);
}

// Killed, it would leave what it has written so far.
ScreenshotJob::~ScreenshotJob()
{
    if (child_ == nullptr || child_->hasEnded())
        return;
    child_->interrupt();
    child_->finish();
}

std::string ScreenshotJob::fault()
{
    if (child_ == nullptr)
        return "no process can be started to draw it";
    const ChildOutcome outcome = child_->finish();
    if (outcome.signal != 0)
        return fmt::format("what drew it was ended ({})", ::strsignal(outcome.signal));
    return outcome.code != 0 ? outcome.error : "";
}

} // namespace dioptre
