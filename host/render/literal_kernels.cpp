#include "render/literal_kernels.h"

#include "render/literal.h"
#include "render/lookup.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

constexpr ShapeRow anchorRow{"anchor", &packed::Shape::anchor};
constexpr ShapeRow axisRow{"axis", &packed::Shape::axis};
constexpr ShapeRow alongURow{"along_u", &packed::Shape::along_u};
constexpr ShapeRow alongVRow{"along_v", &packed::Shape::along_v};
constexpr FineRow anchorLowRow{"anchor_low", &packed::FineShape::anchor_low};
constexpr FineRow fineAxisRow{"axis", &packed::FineShape::axis};
constexpr FineRow axisLowRow{"axis_low", &packed::FineShape::axis_low};
constexpr FineRow alongULowRow{"along_u_low", &packed::FineShape::along_u_low};
constexpr FineRow alongVLowRow{"along_v_low", &packed::FineShape::along_v_low};
constexpr FineRow pointRow{"point", &packed::FineShape::point};
constexpr FineRow pointNormalRow{"point_normal", &packed::FineShape::point_normal};
constexpr FineRow pointNormalLowRow{"point_normal_low", &packed::FineShape::point_normal_low};

template <typename Row>
std::string xyzOf(const PackedObject& object, const Row& row)
{
    return rowText(object, row, ".xyz");
}

// A FineVector.
template <typename High, typename Low>
std::string fine(const PackedObject& object, const High& high, const Low& low)
{
    return fmt::format("fineVector({}, {})", xyzOf(object, high), xyzOf(object, low));
}

bool isCylinder(const PackedObject& object)
{
    return object.kind == packed::KIND_OPEN_CYLINDER || object.kind == packed::KIND_CAPPED_CYLINDER;
}

std::string anchorOf(const PackedObject& object)
{
    return fine(object, anchorRow, anchorLowRow);
}

std::string axisOf(const PackedObject& object)
{
    return fine(object, fineAxisRow, axisLowRow);
}

std::string compensatedArguments(const PackedObject& object)
{
    const auto radius = rowText(object, anchorRow, ".w");
    switch (object.kind) {
    case packed::KIND_SPHERE:
        return anchorOf(object) + ", " + radius;
    case packed::KIND_OPEN_CYLINDER:
    case packed::KIND_CAPPED_CYLINDER:
    case packed::KIND_DISK:
        return fmt::format("{}, {}, {}", anchorOf(object), axisOf(object), radius);
    case packed::KIND_PLANE:
        return anchorOf(object) + ", " + axisOf(object);
    case packed::KIND_RECTANGLE:
        return fmt::format("{}, {}, {}, {}", anchorOf(object), axisOf(object), xyzOf(object, alongURow),
                           xyzOf(object, alongVRow));
    default:
        return fmt::format("{}, {}, {}, {}", anchorOf(object), fine(object, alongURow, alongULowRow),
                           fine(object, alongVRow, alongVLowRow), axisOf(object));
    }
}

std::string curvedArguments(const PackedObject& object)
{
    auto text = fmt::format("{}, {}, {}", xyzOf(object, pointRow),
                            fine(object, pointNormalRow, pointNormalLowRow), rowText(object, pointRow, ".w"));
    if (isCylinder(object))
        text += fmt::format(", {}, {}, {}", xyzOf(object, axisRow), rowText(object, axisRow, ".w"),
                            rowText(object, pointNormalRow, ".w"));
    return text;
}

std::string plainArguments(const PackedObject& object)
{
    const auto anchor = xyzOf(object, anchorRow);
    const auto axis = xyzOf(object, axisRow);
    const auto alongU = xyzOf(object, alongURow);
    const auto alongV = xyzOf(object, alongVRow);
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

std::string argumentsOf(const PackedObject& object, KernelForm form)
{
    return form == KernelForm::compensated ? compensatedArguments(object)
           : form == KernelForm::curved    ? curvedArguments(object)
                                           : plainArguments(object);
}

// "sphere", "fineSphere", "curvedSphere".
std::string kernelOf(int kind, KernelForm form)
{
    constexpr const char* names[packed::KIND_COUNT] = {"Sphere", "OpenCylinder", "CappedCylinder", "Plane",
                                                       "Disk",   "Rectangle",    "Triangle"};
    std::string name = names[kind];
    if (form != KernelForm::plain)
        return (form == KernelForm::compensated ? "fine" : "curved") + name;
    name.front() = static_cast<char>(name.front() + ('a' - 'A'));
    return name;
}

// The normal of a hit on an object's round surface; "" where the plain one serves.
std::string normalCall(const PackedObject& object, KernelForm form)
{
    const bool sphere = object.kind == packed::KIND_SPHERE;
    if (form == KernelForm::plain || (!sphere && !isCylinder(object)))
        return "";
    if (form == KernelForm::compensated)
        return sphere ? fmt::format("fineSphereNormal(place, {})", anchorOf(object))
                      : fmt::format("fineSideNormal(place, {}, {})", anchorOf(object), axisOf(object));
    const auto kappa = rowText(object, pointRow, ".w");
    const auto about = fmt::format("place, {}, {}, {}", xyzOf(object, pointRow),
                                   fine(object, pointNormalRow, pointNormalLowRow), kappa);
    return sphere ? fmt::format("curvedSphereNormal({})", about)
                  : fmt::format("curvedSideNormal({}, {})", about, xyzOf(object, axisRow));
}

// The place of a hit, brought back onto the surface; "" where the plain one serves.
std::string positionCall(const PackedObject& object, KernelForm form)
{
    if (form == KernelForm::plain || isCylinder(object))
        return "";
    const auto call = [&](const char* name) {
        return fmt::format("{}(place, outward, {})", name, argumentsOf(object, form));
    };
    if (object.kind == packed::KIND_SPHERE)
        return call(form == KernelForm::curved ? "onCurvedSphere" : "onFineSphere");
    return fmt::format("onFinePlane(place, {}, {})", anchorOf(object), axisOf(object));
}

// "    name = hit.object == 3 ? call : name;" for each object that has a call.
template <typename CallOf>
std::string choices(const PackedScene& packed, const Plan& plan, const char* name, const char* condition,
                    CallOf callOf)
{
    std::string text;
    for (std::size_t id = 0; id < packed.objects.size(); ++id) {
        const auto call = plan.seen[id] ? callOf(packed.objects[id], plan.kernels[id]) : std::string();
        if (!call.empty())
            text += fmt::format("    {0} = {1} == {2} ? {3} : {0};\n", name, condition, id, call);
    }
    return text;
}

} // namespace

std::string kernelArguments(const PackedObject& object, const Plan& plan, std::size_t id)
{
    return argumentsOf(object, plan.kernels[id]);
}

std::string crossingCall(const PackedObject& object, const Plan& plan, std::size_t id)
{
    return fmt::format("{}{}(ray, {}, {})", kernelOf(object.kind, plan.kernels[id]),
                       plan.enteredOnly[id] ? "Entry" : "Crossing", id, kernelArguments(object, plan, id));
}

std::string spanCall(const PackedObject& object, const Plan& plan, std::size_t id)
{
    return fmt::format("{}Span(ray, {})", kernelOf(object.kind, plan.kernels[id]),
                       argumentsOf(object, plan.kernels[id]));
}

std::string ownKernelText(const PackedScene& packed, const Plan& plan)
{
    const auto own = [&](std::size_t id) -> std::optional<std::string> {
        return plan.kernels[id] == KernelForm::plain ? "false" : "true";
    };
    return fmt::format("// Whether an object's kernel was chosen for precision.\n"
                       "bool hasOwnKernel(int object)\n{{\n    return {};\n}}\n\n",
                       selectText("object", packed.objects.size(), own, "false"));
}

std::string chosenSurfaces(const PackedScene& packed, const Plan& plan)
{
    return "// The normal at a place on an object, where its kernel was chosen for precision.\n"
           "vec3 chosenNormal(vec3 place, Nearest hit, vec3 plain)\n{\n    vec3 normal = plain;\n" +
           choices(packed, plan, "normal", "hit.object", normalCall) +
           "    return hit.cap ? plain : normal;\n}\n\n"
           "// The place itself.\n"
           "vec3 chosenPosition(vec3 place, int object, vec3 outward, vec3 plain)\n{\n"
           "    vec3 position = plain;\n" +
           choices(packed, plan, "position", "object", positionCall) + "    return position;\n}\n\n";
}

} // namespace dioptre
