#include "scene/load.h"

#include "base/file.h"
#include "scene/animated_document.h"
#include "scene/override.h"
#include "scene/sections.h"
#include "scene/table_reader.h"

#include <fmt/format.h>

namespace dioptre
{

const std::vector<std::string>& sceneKeys()
{
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> names{"title",  "camera", "sky",      "trace", "plan",
                                       "raster", "output", "material", "light", "animate"};
        names.insert(names.end(), objectKinds().begin(), objectKinds().end());
        return names;
    }();
    return keys;
}

std::vector<const Value*> tablesUnder(const Table& document, std::string_view key)
{
    std::vector<const Value*> tables;
    if (const Value* value = find(document, key)) {
        const std::string wanted = fmt::format("tables under [[{}]]", key);
        for (const Value& element : arrayFrom(*value, key, wanted)) {
            if (!std::holds_alternative<Table>(element.data))
                refuse(element, key, wanted);
            tables.push_back(&element);
        }
    }
    return tables;
}

Scene readScene(const Value& document, const std::filesystem::path& path, const SearchPlaces& places)
{
    const TableReader reader(document, "a scene", sceneKeys());
    const Table& sections = reader.table();
    const Search pictures = pictureSearch(path, places);
    Scene scene;
    scene.path = path.string();
    reader.text("title", scene.title);
    scene.materials = readMaterials(sections, pictures);
    scene.camera = readCamera(sections, scene.materials);
    scene.sky = readSky(sections, pictures);
    scene.trace = readTrace(sections);
    scene.plan = readPlan(sections);
    scene.raster = readRaster(sections);
    scene.output = readOutput(sections);
    scene.lights = readLights(sections);
    scene.objects = readObjects(sections, scene.materials);
    return scene;
}

namespace
{

void refuseOverridden(const std::vector<Overridden>& overrides, const std::vector<Track>& tracks)
{
    for (const Overridden& change : overrides)
        for (const Track& track : tracks)
            if (overlap(change.steps, track.steps))
                fail(ExitCode::usage, change.place,
                     fmt::format("it is animated at {}, which would take its place", describe(track.where)),
                     "set the animation's values, or take all animations out by --set animate=[]");
}

} // namespace

SceneOverTime parseSceneOverTime(const std::string& text, const std::filesystem::path& path,
                                 const std::vector<std::string>& overrides, const SearchPlaces& places)
{
    Value document = parseDocument(text, path.string());
    const std::vector<Overridden> overridden = applyOverrides(document, overrides);
    Scene still = readScene(document, path, places);
    std::vector<Track> tracks = takeTracks(document);
    if (tracks.empty())
        return [still = std::move(still)](double) { return still; };
    refuseOverridden(overridden, tracks);
    AnimatedDocument animation{std::move(document), std::move(tracks), path, places, {}};
    visitKeys(animation);
    return [animation = std::move(animation)](double time_s) { return sceneAt(animation, time_s); };
}

Scene parseScene(const std::string& text, const std::filesystem::path& path,
                 const std::vector<std::string>& overrides, double time_s, const SearchPlaces& places)
{
    return parseSceneOverTime(text, path, overrides, places)(time_s);
}

std::string readSceneText(const std::filesystem::path& path)
{
    std::string text = readFile(path);
    if (text.find_first_not_of(" \t\r\n") == std::string::npos)
        fail(ExitCode::badInput, {path.string()}, "is empty", "write a scene to it, if only its [camera]");
    return text;
}

Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides, double time_s,
                const SearchPlaces& places)
{
    return parseScene(readSceneText(path), path, overrides, time_s, places);
}

} // namespace dioptre
