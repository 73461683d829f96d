#include "command/command.h"

#include "base/text.h"
#include "command/bench_options.h"
#include "command/compare.h"
#include "command/include_option.h"
#include "command/join.h"
#include "command/live_options.h"
#include "command/method_option.h"
#include "command/size_option.h"
#include "command/stability.h"
#include "gl/context.h"
#include "render/data_view.h"
#include "render/layers.h"
#include "scene/choices.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// What each view shows, for --help.
std::string viewHelp()
{
    std::string text = "draw data in place of light, unencoded, and print what it means:";
    for (const auto& row : dataViews())
        text += fmt::format("\n  {} - {}", row.name, row.shows);
    return text + "\nsamples of a pixel are averaged, so colours mix at edges; --spp 1 keeps them apart";
}

// What each word of a table means, for --help.
template <class Table>
std::string meaningsOf(const Table& table)
{
    std::string text;
    for (const auto& row : table)
        text += fmt::format("\n  {} - {}", row.name, row.meaning);
    return text;
}

std::string layerHelp()
{
    std::string text = "EXR: data beside the colours, separated by commas:";
    for (const auto& row : layerRows())
        text += fmt::format("\n  {} - {}", row.name, row.holds);
    return text;
}

// How the picture is written.
void addOutput(CLI::App& command, RenderOptions& options)
{
    command.add_option("--depth", options.bits, "PNG: bits a channel, 8 or 16; 8 by default")
        ->check(CLI::IsMember({8, 16}))
        ->type_name("BITS");
    command.add_option("--exposure", options.exposure, "PNG: radiance is multiplied by 2^STOPS first")
        ->type_name("STOPS");
    std::vector<std::string> curves;
    for (const auto& row : toneCurves)
        curves.emplace_back(row.name);
    command
        .add_option("--curve", options.curve,
                    "PNG: how radiance becomes 0 to 1 after the exposure:" + meaningsOf(toneCurves))
        ->check(CLI::IsMember(curves))
        ->type_name("CURVE");
    command
        .add_option("--gamma", options.gamma,
                    "PNG: encode by srgb, the default, or by the power 1/NUMBER, after the curve")
        ->type_name("srgb|NUMBER");
    command.add_flag("--half", options.half, "EXR: 16-bit floats");
    command.add_option("--layers", options.layers, layerHelp())
        ->type_name("LAYERS")
        ->delimiter(',')
        ->allow_extra_args(false);
}

// How the picture is drawn in parts.
void addParts(CLI::App& command, RenderOptions& options)
{
    command
        .add_option("--tile", options.tile,
                    "draw the I-th of N parts of the picture, from the top; dioptre join puts them together")
        ->type_name("I/N");
    command
        .add_option("--draw-limit", options.drawLimit_s,
                    "seconds that a draw of a few pixels may take before the shader counts as endless")
        ->type_name("S")
        ->capture_default_str();
}

void addFrames(CLI::App& command, RenderOptions& options)
{
    auto* frames = command.add_option("--frames", options.frames,
                                      "draw these frames, both ends included, to numbered pictures or, where "
                                      "the output is .mp4, .mkv or .webm, by ffmpeg to a video");
    frames->type_name("FIRST:LAST[:STEP]");
    command.add_option("--fps", options.fps, "frames a second: frame N is at --time + N / fps")
        ->needs(frames)
        ->capture_default_str();
    command
        .add_flag("--resume", options.resume,
                  "keep the pictures that are there whole and were drawn with the same settings")
        ->needs(frames);
}

// What plain shaders are fed.
void addPlain(CLI::App& command, RenderOptions& options)
{
    for (std::size_t i = 0; i < options.channels.size(); ++i)
        command
            .add_option(fmt::format("--channel{}", i), options.channels[i],
                        fmt::format("iChannel{} of a plain shader: a picture, or a cube's six", i))
            ->type_name("FILE");
    command
        .add_option("--mouse", options.mouse, "the pointer of a plain shader, in pixels from the lower left")
        ->type_name("X,Y[,down]");
}

void addRender(CLI::App& app, RenderOptions& options, std::string& size)
{
    auto* command = app.add_subcommand("render", "draw a scene or a plain shader without a window");
    command
        ->add_option("input", options.input,
                     "gallery name, scene file (.toml) or plain shader (.frag, .glsl)")
        ->required()
        ->type_name("SCENE|SHADER");
    command
        ->add_option("-o,--output", options.output, "the picture: .png, or .hdr and .exr (linear radiance)")
        ->type_name("FILE");
    command->add_option("--size", size, "width and height in pixels")
        ->type_name("WxH")
        ->default_str("1280x720");
    command->add_option("--spp", options.samples, "samples a pixel")
        ->check(CLI::Range(1, 65536))
        ->capture_default_str();
    command->add_option("--budget", options.budget, "rays a sample, the eye ray included")
        ->check(CLI::Range(1, 4096));
    command->add_option("--time", options.time_s, "the moment of an animated scene, in seconds")
        ->type_name("S")
        ->capture_default_str();
    command
        ->add_option("--set", options.overrides,
                     "change a value of the scene, as trace.form=loop, or a uniform of a plain shader; may "
                     "be repeated")
        ->type_name("PATH=VALUE")
        ->allow_extra_args(false);
    addInclude(*command, options.included);
    addPlain(*command, options);
    command->add_option("--backend", options.backend, "where to draw")
        ->check(CLI::IsMember(backendNames()))
        ->capture_default_str();
    addMethod(*command, options.method);
    command->add_option("--view", options.view, viewHelp())
        ->check(CLI::IsMember(dataViewNames()))
        ->type_name("VIEW");
    addOutput(*command, options);
    addParts(*command, options);
    addFrames(*command, options);
    command->add_flag("--reference", options.reference,
                      "trace in double precision on the CPU, without OpenGL");
    command->add_flag("--why", options.why, "print what the scene needs, what was left out, and why");
    command->add_option("--shader", options.shader, "write the assembled shader, headed by its plan")
        ->type_name("FILE");
    command->add_flag("--json", options.json, "print figures as JSON");
}

void addJoin(CLI::App& app, JoinOptions& options)
{
    auto* command = app.add_subcommand("join", "put the tiles of a picture together, drawn by render --tile");
    command->add_option("parts", options.parts, "the tiles, all of one picture, in any order")
        ->required()
        ->type_name("PART");
    command->add_option("-o,--output", options.output, "the whole picture, of the parts' kind")
        ->required()
        ->type_name("FILE");
    command->add_flag("--json", options.json, "print figures as JSON");
}

void addDoctor(CLI::App& app, DoctorOptions& options)
{
    auto* command = app.add_subcommand("doctor", "say what OpenGL is there and what follows from it");
    command->add_option("--backend", options.backend, "which to try")
        ->check(CLI::IsMember(backendNames()))
        ->capture_default_str();
    command->add_flag("--json", options.json, "print the findings as JSON");
}

void addList(CLI::App& app, ListOptions& options)
{
    auto* command = app.add_subcommand(
        "list", "name the scenes, methods, tree orders, forms, views, layers, curves and more");
    command->add_flag("--json", options.json, "print them as JSON");
}

// CLI11 would only say that a command is missing.
void refuseUnknownCommand(const CLI::App& app, const std::vector<std::string>& arguments)
{
    if (arguments.empty() || arguments.front().starts_with('-'))
        return;
    std::vector<std::string> names;
    for (const auto* command : app.get_subcommands([](const CLI::App*) { return true; }))
        names.push_back(command->get_name());
    if (std::find(names.begin(), names.end(), arguments.front()) == names.end())
        fail(ExitCode::usage, "there is no command '" + arguments.front() + "'",
             "the commands are: " + join(names, ", "));
}

// Of all commands; one of them is filled.
struct CommandOptions {
    RenderOptions render;
    std::string renderSize = "1280x720";
    LiveOptions live;
    BenchOptions bench;
    JoinOptions join;
    CompareOptions compare;
    StabilityOptions stability;
    DoctorOptions doctor;
    ListOptions list;
};

void addCommands(CLI::App& app, CommandOptions& options)
{
    addRender(app, options.render, options.renderSize);
    addLive(app, options.live);
    addBench(app, options.bench);
    addJoin(app, options.join);
    addCompare(app, options.compare);
    addStability(app, options.stability);
    addDoctor(app, options.doctor);
    addList(app, options.list);
}

ExitCode runNamed(const CLI::App& app, CommandOptions& options, const WindowCommands& windows)
{
    if (app.got_subcommand("live"))
        return windows.live(options.live);
    if (app.got_subcommand("bench") && options.bench.reload)
        return windows.benchReload(reloadOptions(options.bench));
    if (app.got_subcommand("bench"))
        return bench(options.bench);
    if (app.got_subcommand("join"))
        return joinTiles(options.join);
    if (app.got_subcommand("compare"))
        return compare(options.compare);
    if (app.got_subcommand("stability"))
        return stability(options.stability);
    if (app.got_subcommand("doctor"))
        return doctor(options.doctor);
    if (app.got_subcommand("list"))
        return list(options.list);
    readSize(options.renderSize, options.render.width, options.render.height);
    return render(options.render);
}

} // namespace

ExitCode runCommandLine(const std::vector<std::string>& arguments, const WindowCommands& windows)
{
    CLI::App app{"dioptre: ray tracing by one GLSL fragment shader", "dioptre"};
    app.set_version_flag("--version", std::string("dioptre ") + DIOPTRE_VERSION);
    app.require_subcommand(1);
    CommandOptions options;
    addCommands(app, options);
    refuseUnknownCommand(app, arguments);
    try {
        // CLI11 takes the arguments from the back.
        app.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend()));
    } catch (const CLI::ParseError& error) {
        if (error.get_exit_code() == 0) {
            app.exit(error);
            return ExitCode::done;
        }
        const bool named = !arguments.empty() && !arguments.front().starts_with('-');
        fail(ExitCode::usage, error.what(),
             "run 'dioptre " + (named ? arguments.front() + " " : "") + "--help' for the options");
    }
    return runNamed(app, options, windows);
}

} // namespace dioptre
