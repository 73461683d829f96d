#include "live/panel_scene_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr double mostRadiance = 1000.0;
constexpr double mostAbsorption = 1000.0; // per metre

std::vector<double> listed(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

bool lightsOnlySpheres(const Scene& scene, std::size_t material)
{
    return std::ranges::all_of(scene.objects, [&](const Object& object) {
        return object.material != material || std::holds_alternative<Sphere>(object.primitive);
    });
}

// A path is cut at its dots and ends at the first '='. A material that the loader appended is in no file.
bool isReachable(const Scene& scene, std::size_t index)
{
    const Material& material = scene.materials[index];
    if (material.name.find_first_of(".=") != std::string::npos)
        return false;
    const bool plain = material.colour == glm::dvec3(1.0) && material.image.empty() && !material.checker &&
                       material.mirror == 0.0 && material.transmit == 0.0 &&
                       material.emission == glm::dvec3(0.0) && material.specular == glm::dvec3(0.0) &&
                       material.model == ReflectanceModel::lambert && !material.ambient;
    return !(material.name == "default" && index + 1 == scene.materials.size() && plain);
}

void addColours(std::vector<PanelRow>& rows, const Material& m)
{
    rows.push_back(
        {.path = "colour", .label = "colour", .kind = RowKind::colour, .numbers = listed(m.colour)});
    if (m.checker)
        for (const int i : {0, 1})
            rows.push_back({.path = fmt::format("colours.{}", i),
                            .label = i == 0 ? "even squares" : "odd squares",
                            .kind = RowKind::colour,
                            .numbers = listed(m.checker->colours[i])});
    if (m.checker || !m.image.empty())
        rows.push_back({.path = "size",
                        .label = "size, m",
                        .numbers = {m.size},
                        .low = 0.01,
                        .high = 100.0,
                        .logarithmic = true,
                        .meaning = "metres that a square or a picture spans"});
    rows.push_back({.path = "ambient",
                    .label = "ambient",
                    .kind = RowKind::colour,
                    .numbers = listed(m.ambient.value_or(m.colour)),
                    .meaning = m.ambient
                                   ? "reflectance for ambient light"
                                   : "reflectance for ambient light: the surface's colour until it is set"});
}

void addShading(std::vector<PanelRow>& rows, const Material& m)
{
    const bool shines = m.model != ReflectanceModel::lambert;
    const bool facets = m.model == ReflectanceModel::microfacet;
    const bool hasLobe = shines && !facets && m.specular != glm::dvec3(0.0);
    rows.push_back({.path = "model",
                    .label = "model",
                    .kind = RowKind::choice,
                    .numbers = {static_cast<double>(m.model)},
                    .high = 3.0,
                    .words = {{"\"lambert\"", "lambert"},
                              {"\"phong\"", "phong"},
                              {"\"blinn\"", "blinn"},
                              {"\"microfacet\"", "microfacet"}}});
    rows.push_back({.path = "specular",
                    .label = "specular",
                    .kind = RowKind::colour,
                    .numbers = listed(m.specular),
                    .hasEffect = shines});
    rows.push_back({.path = "shininess",
                    .label = "shininess",
                    .numbers = {m.shininess},
                    .high = 1000.0,
                    .logarithmic = true,
                    .hasEffect = hasLobe});
    if (facets) {
        rows.push_back({.path = "roughness",
                        .label = "roughness",
                        .numbers = {m.roughness},
                        .low = 0.0001,
                        .logarithmic = true,
                        .meaning = "its square is alpha, about the slope of the facets"});
        rows.push_back({.path = "metalness", .label = "metalness", .numbers = {m.metalness}});
    }
    rows.push_back({.path = "mirror", .label = "mirror", .numbers = {m.mirror}});
    rows.push_back({.path = "mirror_colour",
                    .label = "mirror colour",
                    .kind = RowKind::colour,
                    .numbers = listed(m.mirrorColour),
                    .hasEffect = m.mirror > 0.0});
}

void addMedium(std::vector<PanelRow>& rows, const Material& m)
{
    const bool transmits = m.transmit > 0.0;
    rows.push_back({.path = "transmit", .label = "transmit", .numbers = {m.transmit}});
    rows.push_back({.path = "ior",
                    .label = "ior",
                    .numbers = {m.ior},
                    .low = 1.0,
                    .high = 3.0,
                    .hasEffect = transmits,
                    .meaning = "index of refraction"});
    rows.push_back({.path = "absorption",
                    .label = "absorption",
                    .kind = RowKind::vector,
                    .numbers = listed(m.absorption),
                    .high = mostAbsorption,
                    .hasEffect = transmits,
                    .meaning = "of red, green and blue, per metre"});
    rows.push_back({.path = "shadow",
                    .label = "shadow",
                    .kind = RowKind::choice,
                    .numbers = {static_cast<double>(m.shadow)},
                    .high = 2.0,
                    .words = {{"\"opaque\"", "opaque"}, {"\"tinted\"", "tinted"}, {"\"none\"", "none"}}});
}

void addEmission(std::vector<PanelRow>& rows, const Scene& scene, std::size_t index)
{
    const Material& m = scene.materials[index];
    rows.push_back({.path = "emission",
                    .label = "emission",
                    .kind = RowKind::colour,
                    .numbers = listed(m.emission),
                    .high = mostRadiance,
                    .nonZero = m.light});
    const bool glows = m.emission != glm::dvec3(0.0) && lightsOnlySpheres(scene, index);
    if (glows && !isAnimated(scene, fmt::format("material.{}.emission", m.name)))
        rows.push_back({.path = "light",
                        .label = "lights scene",
                        .kind = RowKind::toggle,
                        .numbers = {m.light ? 1.0 : 0.0},
                        .meaning = "its spheres light the scene from their centres"});
}

} // namespace

std::vector<PanelRow> materialRows(const Scene& scene, std::size_t index)
{
    std::vector<PanelRow> rows;
    if (!isReachable(scene, index))
        return rows;
    const Material& material = scene.materials[index];
    addColours(rows, material);
    addShading(rows, material);
    addMedium(rows, material);
    addEmission(rows, scene, index);
    for (PanelRow& row : rows) {
        row.group = "Materials";
        row.section = material.name;
        row.path = fmt::format("material.{}.{}", material.name, row.path);
    }
    return rows;
}

} // namespace dioptre
