#include "render/literal.h"
#include "render/lookup.h"
#include "render/pack.h"
#include "render/shared_values.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// One value that the tracer reads of a surface's Material.
struct Value {
    const char* target;                         // "mirror", "colour.xyz"
    const char* define;                         // the feature by which it is read
    std::function<bool(const Material&)> holds; // the materials that have one of their own
    const char* rest;                           // what all others have
};

const std::vector<Value>& valuesRead()
{
    static const std::vector<Value> values = {
        {"colour.xyz", "HAS_LOCAL", [](const Material& m) { return m.mirror < 1.0 && m.transmit < 1.0; },
         "vec3(0.0)"},
        {"ambient", "HAS_ANY_AMBIENT", [](const Material& m) { return m.ambient.has_value(); },
         "vec4(0.0, 0.0, 0.0, 1.0)"},
        {"specular", "HAS_HIGHLIGHT", [](const Material& m) { return m.specular != glm::dvec3(0.0); },
         "vec4(0.0)"},
        {"microfacet.xy", "HAS_MICROFACET",
         [](const Material& m) { return m.model == ReflectanceModel::microfacet; }, "vec2(1.0, 0.0)"},
        {"emission.xyz", "HAS_EMISSION", [](const Material& m) { return m.emission != glm::dvec3(0.0); },
         "vec3(0.0)"},
        {"mirror", "HAS_MIRROR_RAY", [](const Material& m) { return m.mirror > 0.0; }, "vec4(0.0)"},
        {"checker", "HAS_CHECKER", [](const Material& m) { return m.checker.has_value(); }, "vec4(0.0)"},
        {"checker_first.xyz", "HAS_CHECKER", [](const Material& m) { return m.checker.has_value(); },
         "vec3(1.0)"},
        {"checker_first.w", "HAS_PLANE_COORDINATES", [](const Material& m) { return wears(m); }, "1.0"},
        {"bending", "HAS_REFRACTION", [](const Material& m) { return m.transmit > 0.0; }, "vec4(1.0)"},
        {"shadow_absorption.w", "HAS_REFRACTION", [](const Material& m) { return m.transmit > 0.0; }, "0.0"},
        {"absorption.w", "HAS_ABSORPTION", [](const Material& m) { return m.outside.has_value(); }, "-1.0"}};
    return values;
}

bool isShared(const Plan& plan, const std::string& name)
{
    return std::ranges::any_of(plan.shared, [&](const SharedValue& value) { return value.name == name; });
}

// "shared_materials[2].mirror", or "u_materials[2].mirror" where it is not shared.
std::string materialValue(const Plan& plan, std::size_t i, const std::string& member)
{
    const auto name = fmt::format("materials[{}].{}", i, member);
    return (isShared(plan, "u_" + name) ? "shared_" : "u_") + name;
}

// "u_materials[2].mirror" for the materials of the plan that have the value.
std::string choice(const std::string& index, const Scene& scene, const Plan& plan, const Value& value)
{
    return selectText(
        index, plan.materials.size(),
        [&](std::size_t i) -> std::optional<std::string> {
            if (!plan.seenMaterials[i])
                return std::nullopt;
            const bool own = value.holds(scene.materials[plan.materials[i]]);
            return own ? materialValue(plan, i, value.target) : value.rest;
        },
        value.rest);
}

// MODEL_ of a material whose highlight is seen.
std::string modelText(const Scene& scene, const Plan& plan)
{
    return selectText(
        "medium", plan.materials.size(),
        [&](std::size_t i) -> std::optional<std::string> {
            const auto& material = scene.materials[plan.materials[i]];
            // A lobe is multiplied by the material's own specular colour, so that one without may have any;
            // not so microfacets.
            const bool matters = canShine(material) || plan.defines.contains("HAS_MICROFACET");
            if (!plan.seenMaterials[i] || !matters)
                return std::nullopt;
            return literal(static_cast<double>(modelOf(material.model)));
        },
        "0.0");
}

// The index of a material's picture, known here.
std::string pictureText(const Scene& scene, const Plan& plan)
{
    return selectText(
        "medium", plan.materials.size(),
        [&](std::size_t i) -> std::optional<std::string> {
            if (!plan.seenMaterials[i])
                return std::nullopt;
            const auto& material = scene.materials[plan.materials[i]];
            const auto found =
                std::ranges::find(plan.pictures, PictureUse{material.image, material.encoding});
            return literal(
                static_cast<double>(found == plan.pictures.end() ? -1 : found - plan.pictures.begin()));
        },
        "-1.0");
}

} // namespace

std::string materialText(const Scene& scene, const Plan& plan)
{
    std::string text =
        "// What is read of an object's material; materials without a feature have its neutral value.\n"
        "Material materialOf(int object)\n{\n    Material material;\n";
    std::string body;
    for (const auto& value : valuesRead())
        if (plan.defines.contains(value.define))
            body +=
                fmt::format("    material.{} = {};\n", value.target, choice("medium", scene, plan, value));
    if (plan.defines.contains("HAS_PICTURES"))
        body += fmt::format("    material.colour.w = {};\n", pictureText(scene, plan));
    if (plan.defines.contains("HAS_HIGHLIGHT"))
        body += fmt::format("    material.emission.w = {};\n", modelText(scene, plan));
    if (body.find("medium ") != std::string::npos)
        text += "    int medium = mediumOf(object);\n";
    return text + body + "    return material;\n}\n\n";
}

std::string absorptionText(const Scene& scene, const Plan& plan)
{
    if (!plan.defines.contains("HAS_ABSORPTION"))
        return "";
    const Value value{"absorption.xyz", "", [](const Material& m) { return m.absorption != glm::dvec3(0.0); },
                      "vec3(0.0)"};
    const auto chosen = selectText(
        "medium", plan.materials.size(),
        [&](std::size_t i) -> std::optional<std::string> {
            const bool own = value.holds(scene.materials[plan.materials[i]]);
            return own ? materialValue(plan, i, value.target) : value.rest;
        },
        value.rest);
    return fmt::format(
        "// Per metre of the medium with that index; -1 is air.\nvec3 absorptionOf(int medium)\n{{\n"
        "    return medium < 0 ? vec3(0.0)\n        : {};\n}}\n\n",
        chosen);
}

std::string shadowMaterial(const Plan& plan, std::size_t i)
{
    const bool shared = isShared(plan, fmt::format("u_materials[{}].shadow_tint.xyz", i)) &&
                        (!plan.defines.contains("HAS_SHADOW_ABSORPTION") ||
                         isShared(plan, fmt::format("u_materials[{}].shadow_absorption.xyz", i)));
    return fmt::format("{}_materials[{}]", shared ? "shared" : "u", i);
}

std::vector<SharedValue> sharedMaterials(const Scene& scene, const Plan& plan)
{
    std::vector<SharedValue> values;
    const auto add = [&](std::size_t i, const std::string& member) {
        const auto dot = member.find('.');
        const int components = dot == std::string::npos ? 4 : static_cast<int>(member.size() - dot - 1);
        values.push_back({fmt::format("u_materials[{}].{}", i, member), components});
    };
    const bool absorbs = plan.defines.contains("HAS_ABSORPTION");
    for (std::size_t i = 0; i < plan.materials.size(); ++i) {
        const auto& material = scene.materials[plan.materials[i]];
        if (plan.defines.contains("HAS_TINTED_SHADOWS") && material.transmit > 0.0) {
            add(i, "shadow_tint.xyz");
            if (plan.defines.contains("HAS_SHADOW_ABSORPTION"))
                add(i, "shadow_absorption.xyz");
        }
        if (absorbs && material.absorption != glm::dvec3(0.0))
            add(i, "absorption.xyz");
    }
    for (const auto& value : valuesRead())
        for (std::size_t i = 0; i < plan.materials.size(); ++i)
            if (plan.seenMaterials[i] && plan.defines.contains(value.define) &&
                value.holds(scene.materials[plan.materials[i]]))
                add(i, value.target);
    return values;
}

} // namespace dioptre
