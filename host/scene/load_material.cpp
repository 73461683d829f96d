#include "scene/sections.h"

#include "scene/table_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

namespace
{

const std::vector<std::string> materialKeys{
    "colour",   "image",    "encoding",  "pattern",    "colours",   "size",   "model",
    "ambient",  "specular", "shininess", "roughness",  "metalness", "mirror", "mirror_colour",
    "transmit", "ior",      "outside",   "absorption", "emission",  "light",  "shadow"};

void readSurface(const TableReader& reader, Material& material, const Search& pictures)
{
    enum class Pattern { none, checker };
    Pattern pattern = Pattern::none;
    reader.choice<Pattern>("pattern", pattern, {{"checker", Pattern::checker}});
    reader.refuseUnless(pattern == Pattern::checker, "colours", "without a pattern",
                        "add pattern = \"checker\"");
    reader.colour("colour", material.colour);
    if (const Value* image = reader.find("image"))
        material.image = pictureFile(*image, "image", pictures);
    const bool pictured = !material.image.empty();
    reader.refuseUnless(pictured, "encoding", "without an image", "take it out");
    reader.choice<Encoding>("encoding", material.encoding,
                            {{"srgb", Encoding::srgb}, {"linear", Encoding::linear}});
    reader.refuseUnless(pictured || pattern == Pattern::checker, "size", "without an image or a pattern",
                        "take it out");
    reader.number("size", material.size, aboveZero);
    if (pattern == Pattern::checker) {
        reader.require({"colours"});
        const std::vector<glm::dvec3> colours = coloursFrom(*reader.find("colours"), "colours", 2);
        material.checker = Checker{{colours[0], colours[1]}, material.size};
    }
}

void readShading(const TableReader& reader, Material& material)
{
    reader.choice<ReflectanceModel>("model", material.model,
                                    {{"lambert", ReflectanceModel::lambert},
                                     {"phong", ReflectanceModel::phong},
                                     {"blinn", ReflectanceModel::blinn},
                                     {"microfacet", ReflectanceModel::microfacet}});
    if (material.model == ReflectanceModel::microfacet)
        material.specular = glm::dvec3(0.04); // head-on, of most plastics and glass
    reader.colour("ambient", material.ambient);
    reader.colour("specular", material.specular);
    reader.number("shininess", material.shininess, zeroOrMore);
    reader.number("roughness", material.roughness, roughness);
    reader.number("metalness", material.metalness, zeroToOne);
    reader.number("mirror", material.mirror, zeroToOne);
    reader.colour("mirror_colour", material.mirrorColour);
}

void readMedium(const TableReader& reader, Material& material, const std::vector<Material>& materials)
{
    reader.number("transmit", material.transmit, zeroToOne);
    reader.number("ior", material.ior, aboveZero);
    reader.vector("absorption", material.absorption, zeroOrMore);
    if (const Value* medium = reader.find("outside"))
        material.outside = materialIndex(*medium, "outside", materials);
    material.shadow = material.transmit > 0.0 ? ShadowKind::tinted : ShadowKind::opaque;
    reader.choice<ShadowKind>(
        "shadow", material.shadow,
        {{"opaque", ShadowKind::opaque}, {"tinted", ShadowKind::tinted}, {"none", ShadowKind::none}});
}

void readEmission(const TableReader& reader, Material& material)
{
    reader.colour("emission", material.emission);
    reader.flag("light", material.light);
    if (material.light && material.emission == glm::dvec3(0.0))
        fail(ExitCode::badInput, reader.where("light"),
             fmt::format("{} is a light without emission", reader.name()), "give it an emission above 0");
}

// A medium that lies, through any number of others, outside itself has no outermost air.
void checkOutside(std::size_t start, const std::vector<Material>& materials, const SourcePosition& where)
{
    std::string chain = materials[start].name;
    std::size_t index = start;
    for (std::size_t step = 0; step < materials.size() && materials[index].outside; ++step) {
        index = *materials[index].outside;
        chain += " -> " + materials[index].name;
        if (index == start)
            fail(ExitCode::badInput, where, fmt::format("outside goes in a circle: {}", chain),
                 "leave one of them in air by taking its outside away");
    }
}

} // namespace

std::size_t materialIndex(const Value& value, std::string_view key, const std::vector<Material>& materials)
{
    const std::string& name = textFrom(value, key, "a material's name");
    const auto material = std::ranges::find(materials, name, &Material::name);
    if (material != materials.end())
        return static_cast<std::size_t>(material - materials.begin());
    std::vector<std::string> names;
    for (const Material& known : materials)
        names.push_back(known.name);
    refuseWord(value.where, fmt::format("no material is called \"{}\"", name), name, names);
}

std::vector<Material> readMaterials(const Table& document, const Search& pictures)
{
    const Value* section = find(document, "material");
    if (!section)
        return {};
    const auto* tables = std::get_if<Table>(&section->data);
    if (!tables)
        refuse(*section, "material", "each its own table, [material.NAME]");

    // The names stand first, so that a material may name a later one as its outside.
    std::vector<Material> materials;
    for (const Entry& entry : tables->entries) {
        materials.emplace_back().name = entry.key;
    }
    for (std::size_t i = 0; i < materials.size(); ++i) {
        const Entry& entry = tables->entries[i];
        const TableReader reader(entry.value, fmt::format("[material.{}]", entry.key), materialKeys);
        readSurface(reader, materials[i], pictures);
        readShading(reader, materials[i]);
        readMedium(reader, materials[i], materials);
        readEmission(reader, materials[i]);
    }
    for (std::size_t i = 0; i < materials.size(); ++i)
        if (materials[i].outside)
            checkOutside(i, materials,
                         find(std::get<Table>(tables->entries[i].value.data), "outside")->where);
    return materials;
}

} // namespace dioptre
