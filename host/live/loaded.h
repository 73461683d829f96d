// What a window shows, from its files up to what the device must do.
#pragma once

#include "base/error.h"
#include "command/input.h"
#include "raster/raster_text.h"
#include "render/assembled_part.h"
#include "render/plain.h"
#include "render/trial.h"
#include "scene/load.h"

#include <array>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// What the user wants to see, apart from the moment.
struct Look {
    Input input;
    std::vector<std::string> overrides;  // path=value, of a scene
    PlainValues values;                  // NAME=value of --set, of a plain shader
    std::array<std::string, 4> channels; // of a plain shader
    SearchPlaces places;                 // of pictures and includes
    std::optional<Camera> camera;        // in place of the scene's; its medium is the scene's
    DataView view = DataView::none;
    std::vector<Method> methods{Method{}}; // of a scene: each is drawn
    int samples = 64;                      // a pixel, that a still picture comes to
    glm::ivec2 size_px{1280, 720};         // of the picture
};

// What draws by one method, or a plain shader.
struct DrawnBy {
    Method method;
    std::string texts;    // of all shaders: equal ones need no compiler
    std::string pictures; // fingerprint of the picture files
    bool operator==(const DrawnBy&) const = default;
};

struct LoadRequest {
    long number = 0; // counts up; by the loader, as the next
    std::chrono::steady_clock::time_point askedAt;
    bool measuresLost = false; // no picture is wanted, but the weight that a small one loses
    Look look;
    double time_s = 0.0;
    PlainFrame frame;                   // of a plain shader
    std::shared_ptr<const Scene> shown; // on which features latch; null at first
    std::vector<DrawnBy> onDevice;      // as Loaded has them: pictures that are there stay there
};

struct LoadedRaster {
    RasterScene scene; // without pictures as below
    RasterTexts texts;
};

struct LoadedScene {
    SceneOverTime atTime;
    std::shared_ptr<const Scene> scene;               // as loaded and latched
    PreparedScene prepared;                           // without pictures where those that are shown do
    std::vector<AssembledPart> parts;                 // none where it is not traced
    std::vector<std::optional<LoadedRaster>> rasters; // by Loaded::drawn; nothing where it is traced
};

// A program that would have to be compiled, and where its lines are from.
struct LoadedTrial {
    ProgramTrial program;
    SourceText fragment;
    SourceText vertex;
};

struct Loaded {
    LoadRequest request;
    ViewSettings view;
    std::optional<LoadedScene> scene;
    std::optional<LoadedPlain> plain;
    HostNumbers sliders;                      // of a plain shader, where nobody has moved them
    PlainSettings plainSettings;              // of a plain shader
    std::vector<LoadedTrial> trials;          // of what would have to be compiled
    std::vector<DrawnBy> drawn;               // by Look::methods; one of a plain shader
    std::vector<std::filesystem::path> files; // that fed it, or would
    double load_ms = 0.0;
};

// Whether the texts are among those.
bool holdsTexts(const std::vector<DrawnBy>& drawn, const std::string& texts);

// Whether all that is to be drawn has texts that are compiled already.
bool needsNoCompiler(const Loaded& next, const Loaded& shown);

// A load that failed still tells the files to look after.
struct LoadOutcome {
    LoadRequest request;
    std::optional<Loaded> loaded;
    std::optional<Error> error;
    std::vector<std::filesystem::path> files;
    std::string stamp; // of the files, from before they were read
};

// A scene at a time under a look: its camera, and its features latched on `before`.
Scene sceneUnder(const Look& look, const SceneOverTime& atTime, double time_s, const Scene* before);

} // namespace dioptre
