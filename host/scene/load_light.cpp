#include "scene/sections.h"

#include "base/text.h"
#include "scene/direction.h"
#include "scene/table_reader.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{

namespace
{

const std::vector<std::string> lightKeys{"kind",     "position",    "direction",  "ambient", "diffuse",
                                         "specular", "attenuation", "cutoff_deg", "exponent"};

// What a kind of light needs and what it takes beside that.
struct LightKind {
    std::string_view name;
    std::vector<std::string> required;
    std::vector<std::string> optional;
};

const LightKind& rulesOf(Light::Kind kind)
{
    static const LightKind rules[] = {
        {"an ambient", {"ambient"}, {}},
        {"a directional", {"direction"}, {"ambient", "diffuse", "specular"}},
        {"a point", {"position"}, {"ambient", "diffuse", "specular", "attenuation"}},
        {"a spot",
         {"position", "direction", "cutoff_deg"},
         {"ambient", "diffuse", "specular", "attenuation", "exponent"}}};
    return rules[static_cast<std::size_t>(kind)];
}

void checkKeys(const TableReader& reader, Light::Kind kind)
{
    const LightKind& rules = rulesOf(kind);
    std::vector<std::string> taken{"kind"};
    taken.insert(taken.end(), rules.required.begin(), rules.required.end());
    taken.insert(taken.end(), rules.optional.begin(), rules.optional.end());
    for (const Entry& entry : reader.table().entries)
        if (std::ranges::find(taken, entry.key) == taken.end())
            fail(ExitCode::badInput, entry.where, fmt::format("{} light takes no {}", rules.name, entry.key),
                 fmt::format("it takes {}", join(taken, ", ")));
    for (const std::string& key : rules.required)
        reader.require({key});
}

void readCone(const TableReader& reader, Light& light)
{
    reader.number("cutoff_deg", light.cutoff_deg, {0.0, 180.0, false, "an angle from 0 to 90, or 180"});
    if (light.cutoff_deg > 90.0 && light.cutoff_deg < 180.0)
        refuse(*reader.find("cutoff_deg"), "cutoff_deg", "an angle from 0 to 90, or 180");
    reader.number("exponent", light.exponent, zeroOrMore);
}

Light readLight(const Value& value)
{
    const TableReader reader(value, "[[light]]", lightKeys);
    reader.require({"kind"});
    Light light;
    reader.choice<Light::Kind>("kind", light.kind,
                               {{"ambient", Light::Kind::ambient},
                                {"directional", Light::Kind::directional},
                                {"point", Light::Kind::point},
                                {"spot", Light::Kind::spot}});
    checkKeys(reader, light.kind);
    if (light.kind == Light::Kind::ambient)
        light.diffuse = glm::dvec3(0.0);
    reader.vector("position", light.position);
    reader.nonZero("direction", light.direction);
    light.direction = unit(light.direction);
    reader.colour("ambient", light.ambient);
    reader.colour("diffuse", light.diffuse);
    light.specular = light.diffuse;
    reader.colour("specular", light.specular);
    reader.vector("attenuation", light.attenuation, zeroOrMore);
    if (light.attenuation == glm::dvec3(0.0))
        fail(ExitCode::badInput, reader.where("attenuation"), "attenuation is zero at every distance",
             "give [1, 0, 0] for a light that does not fade");
    readCone(reader, light);
    return light;
}

} // namespace

std::vector<Light> readLights(const Table& document)
{
    std::vector<Light> lights;
    for (const Value* value : tablesUnder(document, "light"))
        lights.push_back(readLight(*value));
    return lights;
}

} // namespace dioptre
