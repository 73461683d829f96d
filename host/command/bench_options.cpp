#include "command/bench_options.h"

#include "command/include_option.h"
#include "command/method_option.h"
#include "command/size_option.h"
#include "gl/context.h"

#include <CLI/CLI.hpp>

namespace dioptre
{

void addBench(CLI::App& app, BenchOptions& options)
{
    auto* command = app.add_subcommand("bench", "time scenes against each other, in turn");
    command
        ->add_option("inputs", options.inputs,
                     "scenes, each with changes behind an @, as still_life@trace.form=loop,trace.budget=4; "
                     "method=METHOD among them draws it by another method")
        ->required()
        ->type_name("SCENE[@PATH=VALUE,…]");
    command
        ->add_option_function<std::string>(
            "--size", [&options](const std::string& text) { readSize(text, options.width, options.height); },
            "width and height in pixels")
        ->type_name("WxH")
        ->default_str("400x400");
    command
        ->add_option("--spp", options.samples,
                     "samples a pixel in a frame of a scene; plain shaders are asked once")
        ->check(CLI::Range(1, 65536))
        ->default_str("1");
    command
        ->add_option("--frames", options.frames,
                     "frames of each input [30, or those that 20 s an input allow, but 6]")
        ->check(CLI::Range(1, 1000000));
    command
        ->add_option("--cold", options.coldStarts,
                     "processes a input that compile and draw first without the driver's disk cache")
        ->check(CLI::Range(1, 1000))
        ->capture_default_str();
    addMethod(*command, options.method);
    addInclude(*command, options.included);
    command->add_option("--backend", options.backend, "where to draw")
        ->check(CLI::IsMember(backendNames()))
        ->capture_default_str();
    auto* reload = command->add_flag(
        "--reload", options.reload,
        "measure in a window how long edits of a scene take to be seen, by editing a copy of it");
    command->add_option("--edits", options.edits, "of each kind, under --reload")
        ->check(CLI::Range(1, 100000))
        ->needs(reload)
        ->capture_default_str();
    command->add_flag("--python", options.python,
                      "hold a plain Python tracer to them, on the first scene as its file stands");
    command->add_flag("--json", options.json, "print figures as JSON");
    // Not for users: the program starts itself with it, once for every cold start.
    command->add_flag("--cold-start", options.coldStart)->group("");
}

ReloadBenchOptions reloadOptions(const BenchOptions& options)
{
    if (options.inputs.size() != 1)
        fail(ExitCode::usage, "--reload edits one scene", "name one");
    if (options.method != "trace")
        fail(ExitCode::usage, "--reload measures edits of a traced scene, and --method asks for another way",
             "leave it out");
    if (options.samples || options.frames > 0 || options.python)
        fail(ExitCode::usage, "--spp, --frames and --python are for frames, and --reload measures edits",
             "leave them out");
    return {options.inputs.front(), options.width, options.height, options.edits, options.json};
}

} // namespace dioptre
