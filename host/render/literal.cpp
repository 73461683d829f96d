#include "render/literal.h"

#include "render/literal_kernels.h"
#include "render/lookup.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

glm::dvec3 xyz(const glm::dvec4& v)
{
    return glm::dvec3(v.x, v.y, v.z);
}

// The object's name may hold anything; in the shader's comment stands what GLSL's character set allows, and
// no backslash, which would draw the next line into the comment.
std::string commentOf(const Object& object, std::size_t id)
{
    std::string name = object.name.empty() ? "" : ": " + object.name;
    std::ranges::replace_if(
        name, [](char c) { return c < ' ' || c > '~' || c == '\\'; }, '?');
    return fmt::format("    // {}{}\n", id, name);
}

// One statement an object, for all or for those that stand apart from a table.
std::string nearestOfEach(const Scene& scene, const PackedScene& packed, const Plan& plan, bool apart)
{
    std::string text;
    for (std::size_t id = 0; id < packed.objects.size(); ++id) {
        if (!plan.seen[id] || (apart && !packed.objects[id].apart))
            continue;
        text += commentOf(scene.objects[id], id);
        text += fmt::format("    nearest = {}(nearest, {}, {});\n", apart ? "nearerOfAnyOrder" : "nearer",
                            crossingCall(packed.objects[id], plan, id), id);
    }
    return text + "    return nearest;\n}\n\n";
}

std::string nearestHitText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    return "// The first object that the ray meets.\n"
           "Nearest nearestHit(Ray ray)\n{\n    Nearest nearest = nothingYet();\n" +
           nearestOfEach(scene, packed, plan, false);
}

// The factor by which one object lets light through.
std::string throughOne(const PackedObject& object, const Plan& plan, int shadow, std::size_t id)
{
    if (shadow == packed::SHADOW_OPAQUE)
        return fmt::format("unblocked({}, distance)", crossingCall(object, plan, id));
    const auto table = shadowMaterial(plan, static_cast<std::size_t>(object.material));
    if (object.kind == packed::KIND_SPHERE || object.kind == packed::KIND_CAPPED_CYLINDER)
        return fmt::format("solidTint({}, ray, {}, distance, {})", spanCall(object, plan, id), id, table);
    if (object.kind == packed::KIND_PLANE)
        return fmt::format("{}({}, ray, distance, {}, {})",
                           plan.kernels[id] == KernelForm::plain ? "planeTint" : "finePlaneTint",
                           crossingCall(object, plan, id), kernelArguments(object, plan, id), table);
    return fmt::format("wallTint({}, distance, {})", crossingCall(object, plan, id), table);
}

std::string throughEach(const Scene& scene, const PackedScene& packed, const Plan& plan, bool apart)
{
    std::string text = "{\n    float open = 1.0;\n";
    const bool tinted = plan.has("tinted shadows");
    if (tinted)
        text += "    vec3 tint = vec3(1.0);\n";
    for (std::size_t id = 0; id < packed.objects.size(); ++id) {
        const auto& object = packed.objects[id];
        const auto& material = packed.materials[static_cast<std::size_t>(object.material)];
        const int shadow = static_cast<int>(material.shadow_tint.w);
        if (shadow == packed::SHADOW_NONE || (apart && !object.apart))
            continue;
        const bool opaque = shadow == packed::SHADOW_OPAQUE;
        auto factor = throughOne(object, plan, shadow, id);
        if (std::ranges::count(plan.glowing, id) > 0)
            factor = fmt::format("glowing == {} ? {} : {}", id, opaque ? "1.0" : "vec3(1.0)", factor);
        text += commentOf(scene.objects[id], id);
        text += fmt::format("    {} *= {};\n", opaque ? "open" : "tint", factor);
    }
    return text +
           (tinted ? "    return open > 0.0 ? tint : vec3(0.0);\n}\n\n" : "    return vec3(open);\n}\n\n");
}

std::string lightThroughText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    return "// The share of the light from that distance along the ray that arrives; `glowing` does not "
           "shade its own light.\n"
           "vec3 lightThrough(Ray ray, float distance, int glowing)\n" +
           throughEach(scene, packed, plan, false);
}

std::string partText(const glm::dvec4& values, std::string_view part)
{
    return part == ".xyz" ? literal(xyz(values)) : literal(values.w);
}

} // namespace

std::string literal(double value)
{
    const auto text = fmt::format("{}", static_cast<float>(value));
    return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

std::string literal(const glm::dvec3& value)
{
    return fmt::format("vec3({}, {}, {})", literal(value.x), literal(value.y), literal(value.z));
}

std::string literal(const glm::dvec4& value)
{
    return fmt::format("vec4({}, {}, {}, {})", literal(value.x), literal(value.y), literal(value.z),
                       literal(value.w));
}

std::string rowText(const PackedObject& object, const ShapeRow& row, std::string_view part)
{
    if (object.moving >= 0)
        return fmt::format("u_moving[{}].{}{}", object.moving, row.name, part);
    return partText(object.shape.*row.values, part);
}

std::string rowText(const PackedObject& object, const FineRow& row, std::string_view part)
{
    if (object.moving >= 0)
        return fmt::format("u_fine[{}].{}{}", object.moving, row.name, part);
    return partText(object.fine.*row.values, part);
}

std::string literalScene(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    const std::string chosen = plan.choosesKernels() ? chosenSurfaces(packed, plan) : "";
    return nearestHitText(scene, packed, plan) + lightThroughText(scene, packed, plan) + chosen;
}

std::string literalApart(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    return "// The nearer of the first hit so far and of those on objects with kernels of their own.\n"
           "Nearest nearestOfChosen(Ray ray, Nearest soFar)\n{\n    Nearest nearest = soFar;\n" +
           nearestOfEach(scene, packed, plan, true) +
           "// As lightThrough(), of the same.\n"
           "vec3 lightThroughChosen(Ray ray, float distance, int glowing)\n" +
           throughEach(scene, packed, plan, true) + chosenSurfaces(packed, plan);
}

} // namespace dioptre
