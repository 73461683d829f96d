// The commands of the program. Each returns what the process ends with, or throws Error.
#pragma once

#include "base/error.h"

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// What `dioptre live` was asked for.
struct LiveOptions {
    std::string input; // gallery name, scene file, plain shader or picture
    int width = 0;     // of the window, pixels; 0: as remembered, or 1280x720
    int height = 0;
    int samples = 64;                    // that a still picture refines itself to
    double time_s = 0.0;                 // at the start
    double fps = 60.0;                   // of a step
    bool paused = false;                 // time stands still at first
    bool restart = false;                // time begins anew with each reload
    std::vector<std::string> overrides;  // path=value; of a plain shader uniform=value
    std::array<std::string, 4> channels; // of a plain shader: see ChannelSource
    std::string method = "trace";        // what is shown of a scene, as methodNamed() reads it
    std::string compare;                 // what is shown beside it, likewise; "" for nothing
    std::string view;                    // data in place of light; "" for none
    std::string output;                  // of screenshots; the input's name with -1.png and so on where empty
    std::string screenshotSize;          // WxH; "" for the window's own pixels
    double drawLimit_s = 5.0;            // that a small picture of a new program may take
    std::vector<std::string> included;   // folders that scenes and shaders may take files from
    bool hidePanel = false;              // at first
    bool forget = false;                 // neither read nor keep what is remembered of an input
    bool json = false;                   // a line for each event
};

// What `dioptre bench --reload` was asked for.
struct ReloadBenchOptions {
    std::string input; // a scene
    int width = 400;   // of the window, pixels
    int height = 400;
    int edits = 30; // of each kind
    bool json = false;
};

// Commands that need a window, and so its libraries.
struct WindowCommands {
    std::function<ExitCode(const LiveOptions&)> live;
    std::function<ExitCode(const ReloadBenchOptions&)> benchReload;
};

// Reads the command line (without the program's name) and runs the command that it names.
ExitCode runCommandLine(const std::vector<std::string>& arguments, const WindowCommands& windows);

// What `dioptre render` was asked for.
struct RenderOptions {
    std::string input;   // gallery name, scene file, or plain shader
    std::string output;  // .png, .hdr or .exr; the input's name with .png in the current folder where empty
    int width = 1280;    // pixels
    int height = 720;    // pixels
    int samples = 16;    // a pixel
    double time_s = 0.0; // of animations and u_time
    int budget = 0;      // rays a sample; 0 leaves it to the scene
    std::vector<std::string> overrides;  // path=value; of a plain shader uniform=value
    std::vector<std::string> included;   // folders that scenes and shaders may take files from
    std::array<std::string, 4> channels; // of a plain shader: see ChannelSource
    std::string mouse;                   // of a plain shader: "X,Y" or "X,Y,down"; "" for never touched
    std::string backend = "auto";
    std::string method = "trace";    // as methodNamed() reads it
    std::string view;                // data in place of light; "" for none
    bool half = false;               // EXR in 16-bit floats
    int bits = 0;                    // of a PNG's channels, 8 or 16; 0 where unset
    std::optional<double> exposure;  // stops; the scene's where unset
    std::string curve;               // of toneCurves; "" leaves it to the scene
    std::string gamma;               // "srgb" or a number; "" leaves it to the scene
    std::vector<std::string> layers; // channels beside an EXR's colours
    bool reference = false;          // in double precision on the CPU
    bool why = false;
    std::string shader; // file for the assembled shader; "" for none
    bool json = false;
    std::string tile;          // I/N: that part of the picture alone; "" for all of it
    double drawLimit_s = 30.0; // that a single draw may take
    std::string frames;        // A:B or A:B:S; "" for a still
    double fps = 25.0;         // frames a second, of --frames
    bool resume = false;       // keep the frames that are there already
    std::string settingsHash;  // written into a frame's file; "" in a still's
};
ExitCode render(const RenderOptions& options);

// What `dioptre bench` was asked for.
struct BenchOptions {
    std::vector<std::string> inputs; // SCENE or SCENE@path=value,…; the first is what the others are held to
    int width = 400;                 // pixels
    int height = 400;                // pixels
    std::optional<int> samples;      // a pixel, in each frame of a scene; 1 where unset
    std::vector<std::string> included; // folders that scenes and shaders may take files from
    int frames = 0;                    // of each input; 0: as many as a time allows, up to 30
    int coldStarts = 5;                // of each input, each in a process of its own
    std::string method = "trace";      // of scenes that name no other
    std::string backend = "auto";
    bool reload = false; // measure edits in a window instead
    int edits = 30;      // of each kind, then
    bool python = false; // hold a plain Python tracer to them
    bool json = false;
    bool coldStart = false; // be one of those processes
};
ExitCode bench(const BenchOptions& options);

struct DoctorOptions {
    std::string backend = "auto";
    bool json = false;
};
// Prints what OpenGL there is and what follows from it. Gives checkFailed where pictures would come out
// wrong, noOpenGl where none can be drawn.
ExitCode doctor(const DoctorOptions& options);

struct ListOptions {
    bool json = false;
};
// Prints the words that the other commands take: scenes, orders, forms, views, layers, curves, backends.
ExitCode list(const ListOptions& options);

} // namespace dioptre
