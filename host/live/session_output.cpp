#include "live/camera_control.h"
#include "live/panel_output_rows.h"
#include "live/session.h"

#include "base/child_process.h"
#include "base/file.h"
#include "base/write_file.h"
#include "command/size_option.h"
#include "command/still_writer.h"
#include "render/annotation.h"
#include "scene/document_edit.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// "still_life-1.png", or the first number that no file has yet.
std::filesystem::path freeName(const std::filesystem::path& pattern)
{
    for (int number = 1;; ++number) {
        const auto name = pattern.parent_path() / fmt::format("{}-{}{}", pattern.stem().string(), number,
                                                              pattern.extension().string());
        if (!std::filesystem::exists(name))
            return name;
    }
}

} // namespace

void Session::notice(const std::string& text)
{
    model_.notice = text;
    noticedAt_ = LiveClock::Clock::now();
    paints_ = 3;
}

// The window's own pixels as they are shown. In any other size the picture is another program's work: the
// command line's, with what was changed here.
void Session::screenshot()
{
    try {
        const Look look = wanted(model_);
        std::filesystem::path pattern = options_.output;
        if (pattern.empty())
            pattern = look.input.name + ".png";
        const auto path = freeName(pattern);
        RenderOptions render;
        render.input = options_.input;
        render.output = path.string();
        render.samples = stage_.samplesDone();
        render.width = stage_.shown().size_px().x;
        render.height = stage_.shown().size_px().y;
        render.time_s = model_.clock.time_s();
        render.overrides = look.overrides;
        if (look.camera)
            for (const auto& value : overridesOf(*look.camera))
                render.overrides.push_back(value);
        if (options_.screenshotSize.empty()) {
            writePng(path, stage_.shown().read(), {}, settingsOf(render, window_.context()));
        } else {
            std::vector<std::string> words{"/proc/self/exe",
                                           "render",
                                           look.input.path.string(),
                                           "-o",
                                           path.string(),
                                           "--size",
                                           options_.screenshotSize,
                                           "--spp",
                                           std::to_string(look.samples),
                                           "--time",
                                           fmt::format("{}", render.time_s)};
            for (const auto& value : render.overrides)
                words.insert(words.end(), {"--set", value});
            for (const auto& folder : options_.included)
                words.insert(words.end(), {"--include", folder});
            for (std::size_t i = 0; i < look.channels.size(); ++i)
                if (!look.channels[i].empty())
                    words.insert(words.end(), {fmt::format("--channel{}", i), look.channels[i]});
            const auto outcome = runChild(words);
            if (!outcome || outcome->code != 0)
                dioptre::fail(ExitCode::cannotWrite, {path.string()},
                              outcome ? outcome->error : "no process can be started", "mend what it says");
        }
        notice("wrote " + path.string());
        log_.say("screenshot", {{"file", path.string()}});
    } catch (const Error& error) {
        notice(error.what());
        std::fprintf(stderr, "dioptre: %s\n", error.what());
    }
}

// Comments and layout stay; the watcher then finds the file changed, and its values to be those that are
// shown.
void Session::writeBack()
{
    const Look look = wanted(model_);
    try {
        const std::filesystem::path& path = look.input.path;
        if (look.input.plainShader) {
            if (model_.frame.live.sliders.empty())
                return notice("nothing was changed");
            writeFile(path, withDefaults(readFile(path), model_.frame.live.sliders));
            model_.frame.live.sliders.clear();
        } else {
            std::vector<std::string> values;
            for (const auto& [name, value] : model_.changes)
                values.push_back(name + "=" + value);
            if (look.camera)
                for (const auto& value : overridesOf(*look.camera))
                    values.push_back(value);
            if (model_.display)
                for (const auto& value : overridesOf(*model_.display, stage_.loaded()->scene->scene->output))
                    values.push_back(value);
            if (values.empty())
                return notice("nothing was changed");
            writeFile(path, withValues(readFile(path), path.string(), values));
            model_.changes.clear();
            model_.display.reset();
            model_.look.camera.reset();
        }
        notice("wrote " + path.filename().string());
        log_.say("written", {{"file", path.string()}});
    } catch (const Error& error) {
        notice(error.what());
        std::fprintf(stderr, "dioptre: %s\n", error.what());
    }
}

} // namespace dioptre
