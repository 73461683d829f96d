#include "scene/load.h"

#include "base/file.h"
#include "scene/document.h"
#include "scene/override.h"
#include "scene/sections.h"
#include "scene/table_reader.h"

#include <fmt/format.h>

namespace dioptre
{

const std::vector<std::string>& sceneKeys()
{
    static const std::vector<std::string> keys = [] {
        std::vector<std::string> names{"title", "camera", "sky", "trace", "plan", "material", "light"};
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

Scene parseScene(const std::string& text, const std::filesystem::path& path,
                 const std::vector<std::string>& overrides)
{
    Value document = parseDocument(text, path.string());
    applyOverrides(document, overrides);

    const TableReader reader(document, "a scene", sceneKeys());
    const Table& sections = reader.table();
    const std::filesystem::path folder = path.parent_path();
    Scene scene;
    scene.path = path.string();
    reader.text("title", scene.title);
    scene.materials = readMaterials(sections, folder);
    scene.camera = readCamera(sections, scene.materials);
    scene.sky = readSky(sections, folder);
    scene.trace = readTrace(sections);
    scene.plan = readPlan(sections);
    scene.lights = readLights(sections);
    scene.objects = readObjects(sections, scene.materials);
    return scene;
}

Scene loadScene(const std::filesystem::path& path, const std::vector<std::string>& overrides)
{
    return parseScene(readFile(path), path, overrides);
}

} // namespace dioptre
