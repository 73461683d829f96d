#include "command/live_options.h"

#include "command/include_option.h"
#include "command/method_option.h"
#include "command/size_option.h"
#include "render/data_view.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace dioptre
{
namespace
{

void addShownMethods(CLI::App& command, LiveOptions& options)
{
    addMethod(command, options.method);
    command
        .add_option("--compare", options.compare,
                    "split the window: --method left of a divider, this one right of it")
        ->type_name("METHOD[:N]");
}

} // namespace

void addLive(CLI::App& app, LiveOptions& options)
{
    auto* command = app.add_subcommand(
        "live", "show a scene, a plain shader or a picture in a window, and redraw it when its files change");
    command->add_option("input", options.input, "gallery name, scene file, plain shader or picture")
        ->required()
        ->type_name("SCENE|SHADER|PICTURE");
    command
        ->add_option_function<std::string>(
            "--size", [&options](const std::string& text) { readSize(text, options.width, options.height); },
            "width and height of the picture in pixels [as it was left, or 1280x720]")
        ->type_name("WxH");
    command->add_option("--spp", options.samples, "samples a pixel that a still picture refines itself to")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    command->add_option("--time", options.time_s, "the moment to begin at, in seconds")->type_name("S");
    command->add_option("--fps", options.fps, "a step of time is a second over this")
        ->check(CLI::Range(0.001, 1000000.0))
        ->capture_default_str();
    command->add_flag("--paused", options.paused, "time stands still at first");
    command->add_flag("--restart", options.restart, "time begins anew with each reload");
    command
        ->add_option("--set", options.overrides,
                     "change a value of the scene, or a uniform of a plain shader; may be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    for (std::size_t i = 0; i < options.channels.size(); ++i)
        command
            ->add_option(fmt::format("--channel{}", i), options.channels[i],
                         fmt::format("iChannel{} of a plain shader: a picture, or a cube's six", i))
            ->type_name("FILE");
    addInclude(*command, options.included);
    addShownMethods(*command, options);
    command->add_option("--view", options.view, "show data in place of light, as render's --view")
        ->check(CLI::IsMember(dataViewNames()))
        ->type_name("VIEW");
    command->add_option("-o,--output", options.output, "where screenshots go; they are numbered")
        ->type_name("FILE.png");
    command
        ->add_option("--screenshot", options.screenshotSize,
                     "width and height of screenshots [the window's own pixels]")
        ->type_name("WxH");
    command
        ->add_option("--draw-limit", options.drawLimit_s,
                     "seconds that a small picture of an edited shader may take before it counts as endless")
        ->type_name("S")
        ->capture_default_str();
    command->add_flag("--no-panel", options.hidePanel, "hide the panel at first; Tab shows it");
    command->add_flag("--forget", options.forget,
                      "neither use nor keep what is remembered: window, panel, camera");
    command->add_flag("--json", options.json, "print a line of JSON for each event");
}

} // namespace dioptre
