#include "live/panel_output_rows.h"
#include "live/session.h"

#include "base/file.h"
#include "base/write_file.h"
#include "command/still_writer.h"
#include "render/annotation.h"
#include "scene/document_edit.h"

#include <utility>

namespace dioptre
{

void Session::notice(const std::string& text)
{
    model_.notice = text;
    noticedAt_ = LiveClock::Clock::now();
    paints_ = 3;
}

void Session::refuse(const Error& error)
{
    notice(error.what());
    std::fprintf(stderr, "dioptre: %s\n", error.what());
    log_.say("error", {{"text", error.what()}, {"code", static_cast<int>(error.code())}, {"stale", false}});
}

// The window's own pixels as they are shown. In any other size the picture is another process's work: the
// command line's, with what was changed here.
void Session::screenshot()
{
    const MethodChoice& methods = model_.methods;
    if (shot_)
        return notice("a screenshot is being drawn already");
    try {
        const auto path =
            freeName(options_.output.empty() ? model_.look.input.name + ".png" : options_.output);
        if (!options_.screenshotSize.empty()) {
            shot_.emplace(
                renderWords(model_, *stage_.loaded(), stage_.facts().uniforms, options_.screenshotSize, path),
                path);
            return notice("drawing " + path.string() + whatShotLacks(methods));
        }
        RenderOptions settings;
        settings.input = input_.shownFile().string();
        settings.samples = stage_.samplesDone();
        settings.width = stage_.size_px().x;
        settings.height = stage_.size_px().y;
        settings.time_s = model_.clock.time_s();
        if (stage_.loaded()->scene)
            settings.method = nameOf(methods);
        settings.overrides = valuesShown(model_, *stage_.loaded(), stage_.facts().uniforms);
        writePng(path, stage_.read(), {}, settingsOf(settings, window_.context()));
        notice("wrote " + path.string());
        log_.say("screenshot", {{"file", path.string()}});
    } catch (const Error& error) {
        refuse(error);
    }
}

void Session::hearOfScreenshot()
{
    if (!shot_ || !shot_->isDone())
        return;
    const std::string fault = shot_->fault();
    const std::string file = shot_->file().string();
    shot_.reset();
    notice(fault.empty() ? "wrote " + file : fault);
    if (fault.empty())
        log_.say("screenshot", {{"file", file}});
    else
        std::fprintf(stderr, "%s\n", fault.c_str());
}

// Comments and layout stay; the watcher then finds the file changed, and its values to be those that are
// shown.
void Session::writeBack()
{
    const std::filesystem::path& path = model_.look.input.path;
    try {
        if (!showsInput())
            return notice(path.filename().string() + " is not shown yet");
        if (!input_.picture.empty())
            return notice("a picture has no values to write");
        if (model_.look.input.plainShader) {
            if (model_.frame.live.sliders.empty())
                return notice("nothing was changed");
            writeFile(path, withDefaults(readFile(path), model_.frame.live.sliders));
            for (const auto& [name, numbers] : std::exchange(model_.frame.live.sliders, {}))
                forgetGiven(model_, name);
        } else {
            const std::size_t given = model_.given.size(); // by --set, and not by hand
            std::vector<std::string> values = valuesShown(model_, *stage_.loaded(), stage_.facts().uniforms);
            values.erase(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(given));
            if (values.empty())
                return notice("nothing was changed");
            writeFile(path, withValues(readFile(path), path.string(), values));
            for (const auto& value : values)
                forgetGiven(model_, pathOf(value));
            std::erase_if(model_.changes,
                          [&](const auto& change) { return !isOverGiven(model_, change.first); });
            model_.display.reset();
        }
        notice("wrote " + path.filename().string());
        log_.say("written", {{"file", path.string()}});
    } catch (const Error& error) {
        refuse(error);
    }
}

} // namespace dioptre
