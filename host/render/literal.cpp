#include "render/literal.h"

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

constexpr ShapeRow anchorRow{"anchor", &packed::Shape::anchor};
constexpr ShapeRow axisRow{"axis", &packed::Shape::axis};
constexpr ShapeRow alongURow{"along_u", &packed::Shape::along_u};
constexpr ShapeRow alongVRow{"along_v", &packed::Shape::along_v};

// A kernel's arguments after the ray and the object.
std::string geometry(const PackedObject& object)
{
    const auto anchor = rowText(object, anchorRow, ".xyz");
    const auto axis = rowText(object, axisRow, ".xyz");
    const auto alongU = rowText(object, alongURow, ".xyz");
    const auto alongV = rowText(object, alongVRow, ".xyz");
    const auto radius = rowText(object, anchorRow, ".w");
    switch (object.kind) {
    case packed::KIND_SPHERE:
        return anchor + ", " + radius;
    case packed::KIND_OPEN_CYLINDER:
    case packed::KIND_CAPPED_CYLINDER:
        return fmt::format("{}, {}, {}, {}", anchor, axis, radius, rowText(object, axisRow, ".w"));
    case packed::KIND_PLANE:
        return anchor + ", " + axis;
    case packed::KIND_DISK:
        return fmt::format("{}, {}, {}", anchor, axis, radius);
    case packed::KIND_RECTANGLE:
        return fmt::format("{}, {}, {}, {}", anchor, axis, alongU, alongV);
    default:
        return fmt::format("{}, {}, {}, {}", anchor, alongU, alongV, axis);
    }
}

const char* kernelOf(int kind)
{
    constexpr const char* names[packed::KIND_COUNT] = {"sphere", "openCylinder", "cappedCylinder", "plane",
                                                       "disk",   "rectangle",    "triangle"};
    return names[kind];
}

std::string crossingOf(const PackedObject& object, const Plan& plan, std::size_t id)
{
    return fmt::format("{}{}(ray, {}, {})", kernelOf(object.kind),
                       plan.enteredOnly[id] ? "Entry" : "Crossing", id, geometry(object));
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

std::string nearestHitText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    std::string text = "// The first object that the ray meets.\n"
                       "Nearest nearestHit(Ray ray)\n{\n    Nearest nearest = nothingYet();\n";
    for (std::size_t id = 0; id < packed.objects.size(); ++id) {
        if (!plan.seen[id])
            continue;
        text += commentOf(scene.objects[id], id);
        text += fmt::format("    nearest = nearer(nearest, {}, {});\n",
                            crossingOf(packed.objects[id], plan, id), id);
    }
    return text + "    return nearest;\n}\n\n";
}

// The factor by which one object lets light through.
std::string throughOne(const PackedObject& object, const Plan& plan, int shadow, std::size_t id)
{
    if (shadow == packed::SHADOW_OPAQUE)
        return fmt::format("unblocked({}, distance)", crossingOf(object, plan, id));
    const auto table = shadowMaterial(plan, static_cast<std::size_t>(object.material));
    if (object.kind == packed::KIND_SPHERE || object.kind == packed::KIND_CAPPED_CYLINDER)
        return fmt::format("solidTint({}Span(ray, {}), ray, {}, distance, {})", kernelOf(object.kind),
                           geometry(object), id, table);
    if (object.kind == packed::KIND_PLANE)
        return fmt::format("planeTint({}, ray, distance, {}, {})", crossingOf(object, plan, id),
                           geometry(object), table);
    return fmt::format("wallTint({}, distance, {})", crossingOf(object, plan, id), table);
}

std::string lightThroughText(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    std::string text =
        "// The share of the light from that distance along the ray that arrives; `glowing` does not shade "
        "its own light.\n"
        "vec3 lightThrough(Ray ray, float distance, int glowing)\n{\n    float open = 1.0;\n";
    const bool tinted = plan.has("tinted shadows");
    if (tinted)
        text += "    vec3 tint = vec3(1.0);\n";
    for (std::size_t id = 0; id < packed.objects.size(); ++id) {
        const auto& object = packed.objects[id];
        const auto& material = packed.materials[static_cast<std::size_t>(object.material)];
        const int shadow = static_cast<int>(material.shadow_tint.w);
        if (shadow == packed::SHADOW_NONE)
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
    const glm::dvec4& values = object.shape.*row.values;
    return part == ".xyz" ? literal(xyz(values)) : literal(values.w);
}

std::string literalScene(const Scene& scene, const PackedScene& packed, const Plan& plan)
{
    return nearestHitText(scene, packed, plan) + lightThroughText(scene, packed, plan);
}

} // namespace dioptre
