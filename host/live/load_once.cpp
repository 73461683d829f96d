#include "live/load_once.h"

#include "base/clock.h"
#include "base/file.h"
#include "raster/raster_trial.h"
#include "render/input_files.h"
#include "render/latch.h"
#include "render/pack.h"
#include "render/shared_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <sys/stat.h>
#include <utility>

namespace dioptre
{
namespace
{

// What changes when a file's contents do.
std::string fingerprintOf(const std::string& path)
{
    struct stat file {
    };
    if (::stat(path.c_str(), &file) != 0)
        return path + " none\n";
    return fmt::format("{} {} {} {} {}\n", path, file.st_ino, file.st_size, file.st_mtim.tv_sec,
                       file.st_mtim.tv_nsec);
}

ViewSettings viewOf(const LoadRequest& request)
{
    ViewSettings view;
    view.width = request.look.size_px.x;
    view.height = request.look.size_px.y;
    view.samples = request.look.samples;
    view.view = request.look.view;
    view.glslFolder = request.look.places.glslFolder;
    view.pictures = pictureCache();
    // What the helper has passed is waited for: a limit would end the process.
    view.drawLimit_s = std::numeric_limits<double>::infinity();
    return view;
}

std::string picturesOf(const Scene& scene, const Plan& plan)
{
    std::string all;
    for (const auto& use : plan.pictures)
        all += fmt::format("{} {}", static_cast<int>(use.encoding), fingerprintOf(use.path));
    if (plan.has("sky picture") && scene.sky.kind == Sky::Kind::image)
        all += fmt::format("sky {} {}", static_cast<int>(scene.sky.encoding), fingerprintOf(scene.sky.image));
    return all;
}

// From memory where they are the ones that were loaded last.
void takePictures(const Scene& scene, const Plan& plan, PackedScene& packed, const PictureCache& cache,
                  KeptPictures& kept)
{
    const std::string fingerprint = picturesOf(scene, plan);
    if (kept.fingerprint != fingerprint) {
        kept = {};
        PackedScene loaded;
        loadPictures(scene, plan, loaded, cache);
        kept = {fingerprint, std::move(loaded.pictures), std::move(loaded.sky_picture), {}};
    }
    packed.pictures = std::move(kept.pictures);
    packed.sky_picture = std::move(kept.sky);
    packed.skyPictureBrightness = kept.skyBrightness;
}

// They go on with what is loaded where the device is to get them, and are kept in any case.
void givePicturesBack(PackedScene& packed, bool isOnDevice, KeptPictures& kept)
{
    kept.skyBrightness = packed.skyPictureBrightness;
    if (isOnDevice) {
        kept.pictures = std::move(packed.pictures);
        kept.sky = std::move(packed.sky_picture);
        packed.pictures.clear();
        packed.sky_picture.clear();
    } else {
        kept.pictures = packed.pictures;
        kept.sky = packed.sky_picture;
    }
}

PictureSource picturesFrom(KeptPictures& kept, const PictureCache& cache)
{
    return [&](const Scene& seen, const Plan& plan, PackedScene& packed) {
        takePictures(seen, plan, packed, cache, kept);
    };
}

// What is only planned asks for none: any brightness of a sky will do.
void withoutPictures(const Scene&, const Plan&, PackedScene& packed)
{
    packed.skyPictureBrightness = 1.0;
}

// Ends the loading of one method: what it is drawn by, its trials, its pictures.
void addDrawn(Loaded& loaded, const DrawnBy& drawn, PackedScene& packed, std::vector<LoadedTrial> trials,
              KeptPictures& kept)
{
    const auto& onDevice = loaded.request.onDevice;
    loaded.drawn.push_back(drawn);
    if (!holdsTexts(onDevice, drawn.texts))
        std::ranges::move(trials, std::back_inserter(loaded.trials));
    givePicturesBack(packed, std::ranges::find(onDevice, drawn) != onDevice.end(), kept);
}

void loadTraced(Loaded& loaded, LoadedScene& result, const DeviceTraits& device, KeptPictures& kept)
{
    DrawnBy drawn{Method{}, "", kept.fingerprint};
    result.parts = assembleParts(result.prepared, loaded.view.glslFolder, device.shader);
    std::vector<LoadedTrial> trials;
    for (const auto& part : result.parts)
        drawn.texts += flatten(part.shader) + flatten(part.vertex);
    if (!holdsTexts(loaded.request.onDevice, drawn.texts))
        for (const auto& part : result.parts)
            trials.push_back({trialOf(part, result.prepared.packed), part.shader, part.vertex});
    addDrawn(loaded, drawn, result.prepared.packed, std::move(trials), kept);
}

void loadRaster(Loaded& loaded, LoadedScene& result, const Method& method, KeptPictures& kept)
{
    LoadedRaster raster;
    raster.scene =
        prepareRaster(*result.scene, loaded.view, method, picturesFrom(kept, loaded.view.pictures));
    raster.texts = rasterTexts(raster.scene, loaded.view.glslFolder);
    DrawnBy drawn{method, "", kept.fingerprint};
    std::vector<LoadedTrial> trials;
    const auto texts = textsOfAll(raster.texts);
    for (const auto& text : texts)
        drawn.texts += flatten(text.fragment) + flatten(text.vertex);
    if (!holdsTexts(loaded.request.onDevice, drawn.texts))
        for (const auto& text : texts)
            trials.push_back({trialOf(raster.scene, text), text.fragment, text.vertex});
    addDrawn(loaded, drawn, raster.scene.prepared.packed, std::move(trials), kept);
    result.rasters.back() = std::move(raster);
}

void loadScene(Loaded& loaded, const DeviceTraits& device, const std::string& text, KeptForMethods& kept)
{
    const LoadRequest& request = loaded.request;
    const Look& look = request.look;
    LoadedScene result;
    result.atTime = parseSceneOverTime(text, look.input.path, look.overrides, look.places);
    result.scene =
        std::make_shared<Scene>(sceneUnder(look, result.atTime, request.time_s, request.shown.get()));
    const auto traced = std::ranges::find(look.methods, Method{});
    const auto place = static_cast<std::size_t>(traced - look.methods.begin());
    result.prepared =
        prepare(*result.scene, loaded.view,
                traced == look.methods.end() ? PictureSource(withoutPictures)
                                             : picturesFrom(kept.at(place), loaded.view.pictures));
    for (std::size_t i = 0; i < look.methods.size(); ++i) {
        result.rasters.emplace_back();
        if (isRasterised(look.methods[i]))
            loadRaster(loaded, result, look.methods[i], kept.at(i));
        else
            loadTraced(loaded, result, device, kept.at(i));
    }
    for (std::size_t i = look.methods.size(); i < kept.size(); ++i)
        kept.at(i) = {};
    loaded.scene = std::move(result);
}

void loadShader(Loaded& loaded, const DeviceTraits& device)
{
    const LoadRequest& request = loaded.request;
    PlainSettings& settings = loaded.plainSettings;
    for (std::size_t i = 0; i < settings.channels.size(); ++i)
        settings.channels[i] = channelSource(request.look.channels[i], i);
    settings.frame = request.frame;
    settings.values = request.look.values;
    settings.included = request.look.places.included;
    DrawnBy drawn;
    for (const auto& channel : settings.channels)
        for (const auto& file : channel.files)
            drawn.pictures += fingerprintOf(file);
    loaded.plain = loadPlain(request.look.input.path, loaded.view, settings, device.software);
    loaded.sliders = sliderStarts(loaded.plain->text.text);
    for (const auto& [name, value] : settings.values)
        loaded.sliders.erase(name);
    settings.frame.live.sliders.insert(loaded.sliders.begin(), loaded.sliders.end());
    drawn.texts = flattenWithoutComments(loaded.plain->text.text);
    for (const auto kind : loaded.plain->form.channels)
        drawn.texts += kind == ChannelKind::cube ? "c" : "p";
    if (!holdsTexts(request.onDevice, drawn.texts))
        loaded.trials.push_back({trialOf(*loaded.plain, settings), loaded.plain->text.text, {}});
    loaded.drawn.push_back(std::move(drawn));
}

std::vector<std::filesystem::path> filesOf(const Look& look, const std::string& text)
{
    if (!look.input.plainShader) {
        auto files = filesOfScene(look.input.path, text, look.places);
        if (std::ranges::any_of(look.methods, isRasterised))
            for (auto& file : filesOfSources(rasterSources(), look.places))
                if (std::ranges::find(files, file) == files.end())
                    files.push_back(std::move(file));
        return files;
    }
    auto files = filesOfShader(look.input.path, look.places);
    for (std::size_t i = 0; i < look.channels.size(); ++i)
        for (const auto& file : channelSource(look.channels[i], i).files)
            files.emplace_back(file);
    return files;
}

} // namespace

Scene sceneUnder(const Look& look, const SceneOverTime& atTime, double time_s, const Scene* before)
{
    Scene scene = atTime(time_s);
    if (look.camera) {
        const auto inside = scene.camera.inside;
        scene.camera = *look.camera;
        scene.camera.inside = inside;
    }
    // One program draws all of the picture: its parts would move with the camera.
    for (Scene* each : {&scene, scene.typical.empty() ? &scene : &scene.typical.front()})
        each->plan.tiles = PlanChoices::Tiles::off;
    if (before != nullptr)
        latch(scene, *before);
    return scene;
}

bool holdsTexts(const std::vector<DrawnBy>& drawn, const std::string& texts)
{
    return std::ranges::find(drawn, texts, &DrawnBy::texts) != drawn.end();
}

bool needsNoCompiler(const Loaded& next, const Loaded& shown)
{
    return next.scene.has_value() == shown.scene.has_value() &&
           std::ranges::all_of(next.drawn,
                               [&](const DrawnBy& drawn) { return holdsTexts(shown.drawn, drawn.texts); });
}

std::string stampOf(const std::vector<std::filesystem::path>& files)
{
    std::string all;
    for (const auto& file : files)
        all += fingerprintOf(file.string());
    return all;
}

LoadOutcome loadOnce(const LoadRequest& request, const DeviceTraits& device, KeptForMethods& kept)
{
    LoadOutcome outcome;
    outcome.request = request;
    outcome.files = {request.look.input.path};
    outcome.stamp = stampOf(outcome.files);
    try {
        Stopwatch watch;
        Loaded loaded;
        loaded.request = request;
        loaded.view = viewOf(request);
        const bool plain = request.look.input.plainShader;
        const std::string text = plain ? "" : readFile(request.look.input.path);
        const std::string before = std::exchange(outcome.stamp, "");
        outcome.files = filesOf(request.look, text);
        outcome.stamp = stampOf(outcome.files);
        if (stampOf({request.look.input.path}) != before)
            outcome.stamp += "saved since its files were found\n";
        if (plain)
            loadShader(loaded, device);
        else
            loadScene(loaded, device, text, kept);
        loaded.files = outcome.files;
        loaded.load_ms = watch.lap_ms();
        outcome.loaded = std::move(loaded);
    } catch (const Error& error) {
        outcome.error = error;
    } catch (const std::exception& error) {
        outcome.error = Error(ExitCode::checkFailed, std::string("unexpected: ") + error.what());
    }
    if (outcome.error) // what was on its way may be lost
        kept = {};
    return outcome;
}

} // namespace dioptre
