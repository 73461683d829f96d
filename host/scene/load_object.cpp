#include "scene/primitive.h"
#include "scene/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace dioptre
{

namespace
{

struct Source {
    const Value* value;
    const PrimitiveKind* kind;
};

// All kinds mingled in the order of the file, which gives the objects their ids.
std::vector<Source> inFileOrder(const Table& document)
{
    std::vector<Source> sources;
    for (const PrimitiveKind& kind : primitiveKinds())
        for (const Value* value : tablesUnder(document, kind.key))
            sources.push_back({value, &kind});
    std::ranges::stable_sort(sources, {}, [](const Source& source) {
        return std::tuple(source.value->where.line, source.value->where.column);
    });
    return sources;
}

std::size_t defaultMaterial(std::vector<Material>& materials)
{
    constexpr std::string_view name = "default";
    const auto found = std::ranges::find(materials, name, &Material::name);
    const auto index = static_cast<std::size_t>(found - materials.begin());
    if (found == materials.end())
        materials.emplace_back().name = name;
    return index;
}

// Such a material's light starts at the object's centre, at a distance that only a sphere keeps.
void checkLight(const Object& object, const PrimitiveKind& kind, const Material& material)
{
    if (material.light && !std::holds_alternative<Sphere>(object.primitive))
        fail(ExitCode::badInput, object.where,
             fmt::format("a {} has the material \"{}\", which is a light, and only spheres can be lights",
                         kind.key, material.name),
             "give it a material without 'light', or make it a sphere");
}

Object readObject(const Source& source, std::vector<Material>& materials)
{
    std::vector<std::string> keys = source.kind->required;
    keys.insert(keys.end(), source.kind->optional.begin(), source.kind->optional.end());
    keys.insert(keys.end(), {"name", "material", "rotate_texture_deg"});
    const TableReader reader(*source.value, fmt::format("[[{}]]", source.kind->key), keys);
    for (const std::string& key : source.kind->required)
        reader.require({key});

    Object object;
    object.where = reader.where();
    object.primitive = source.kind->read(reader);
    reader.text("name", object.name);
    reader.number("rotate_texture_deg", object.rotateTexture_deg, anyNumber);
    const Value* material = reader.find("material");
    object.material = material ? materialIndex(*material, "material", materials) : defaultMaterial(materials);
    checkLight(object, *source.kind, materials[object.material]);
    return object;
}

} // namespace

const std::vector<std::string>& objectKinds()
{
    static const std::vector<std::string> names = [] {
        std::vector<std::string> keys;
        for (const PrimitiveKind& kind : primitiveKinds())
            keys.push_back(kind.key);
        return keys;
    }();
    return names;
}

std::vector<Object> readObjects(const Table& document, std::vector<Material>& materials)
{
    std::vector<Object> objects;
    std::map<std::string, SourcePosition> named;
    for (const Source& source : inFileOrder(document)) {
        objects.push_back(readObject(source, materials));
        const std::string& name = objects.back().name;
        if (name.empty())
            continue;
        const auto [first, isNew] = named.emplace(name, objects.back().where);
        if (!isNew)
            fail(ExitCode::badInput, find(std::get<Table>(source.value->data), "name")->where,
                 fmt::format("the name \"{}\" is taken by the object at {}", name, describe(first->second)),
                 "choose another name");
    }
    return objects;
}

} // namespace dioptre
