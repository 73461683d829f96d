#include "support/rendering.h"

#include "base/file.h"
#include "kernel/reference.h"
#include "raster/raster_renderer.h"
#include "render/renderer.h"
#include "scene/load.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace dioptre::test
{
namespace
{

ViewSettings settingsOf(const Request& request)
{
    return {request.width, request.height, request.samples, glslFolder(), {}, request.view};
}

Rendered drawn(Drawing& drawing, const ViewSettings& settings)
{
    const PixelRectangle whole{0, 0, settings.width, settings.height};
    Still still = drawStill(drawing, whole);
    Rendered rendered{drawing.facts(), std::move(still.picture), still.counts, 0.0};
    rendered.raysPerSample = still.counts.rays / static_cast<double>(whole.area()) / settings.samples;
    return rendered;
}

Rendered renderLoaded(const Scene& scene, const Request& request)
{
    const auto settings = settingsOf(request);
    if (const Method method = methodNamed(request.method); isRasterised(method)) {
        contextFor(request.backend);
        const RasterScene raster = prepareRaster(scene, settings, method);
        RasterRenderer renderer(raster, settings);
        return drawn(renderer, settings);
    }
    return renderPrepared(prepare(scene, settings), settings, request.backend);
}

Picture renderLoadedDouble(const Scene& scene, const Request& request)
{
    return renderReference(prepare(scene, settingsOf(request)).packed, request.width, request.height,
                           request.samples, {0, 0, request.width, request.height});
}

// Where a scene given as text is taken to lie: it finds the gallery's pictures.
const std::filesystem::path besideTheGallery =
    std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "text.toml";

} // namespace

std::filesystem::path glslFolder()
{
    const char* chosen = std::getenv("DIOPTRE_GLSL");
    return chosen != nullptr ? std::filesystem::path(chosen)
                             : std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";
}

// Mutants have no textures/ beside them.
SearchPlaces places()
{
    return {{}, std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl"};
}

std::vector<std::filesystem::path> galleryScenes()
{
    std::vector<std::filesystem::path> scenes;
    const auto folder = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

std::vector<std::string> ownPictures(const std::filesystem::path& scene)
{
    if (readFile(scene).find("earth.jpg") == std::string::npos)
        return {};
    return {"material.planet.image=planet.png"};
}

const ContextInfo& contextFor(const std::string& backend)
{
    static std::pair<std::string, std::unique_ptr<Context>> current;
    if (current.second == nullptr || current.first != backend) {
        current.second.reset();
        current = {backend, makeContext(backend)};
    }
    return current.second->info();
}

Rendered renderPrepared(const PreparedScene& prepared, const ViewSettings& settings,
                        const std::string& backend)
{
    Renderer renderer(prepared, settings, contextFor(backend));
    return drawn(renderer, settings);
}

std::vector<Rendered> rasteriseMoments(const std::filesystem::path& scene, const Request& request,
                                       const std::vector<double>& moments_s)
{
    const auto settings = settingsOf(request);
    const auto at = [&](double time_s) { return loadScene(scene, request.overrides, time_s, places()); };
    contextFor(request.backend);
    RasterScene raster = prepareRaster(at(moments_s.front()), settings, methodNamed(request.method));
    RasterRenderer renderer(raster, settings);
    std::vector<Rendered> pictures;
    for (const double time_s : moments_s) {
        moveTo(raster, at(time_s), settings);
        renderer.update(raster);
        pictures.push_back(drawn(renderer, settings));
    }
    return pictures;
}

Rendered renderScene(const std::filesystem::path& scene, const Request& request)
{
    return renderLoaded(loadScene(scene, request.overrides, request.time_s, places()), request);
}

Rendered renderSceneText(const std::string& toml, const Request& request)
{
    return renderLoaded(parseScene(toml, besideTheGallery, request.overrides, request.time_s, places()),
                        request);
}

Picture renderDouble(const std::filesystem::path& scene, const Request& request)
{
    return renderLoadedDouble(loadScene(scene, request.overrides, request.time_s, places()), request);
}

Picture renderDoubleText(const std::string& toml, const Request& request)
{
    return renderLoadedDouble(parseScene(toml, besideTheGallery, request.overrides, request.time_s, places()),
                              request);
}

} // namespace dioptre::test
