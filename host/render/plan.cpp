#include "render/plan.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace dioptre
{
namespace
{

// The rows of the plan are written by functions that look at the scene through this.
class Planner
{
public:
    explicit Planner(const Scene& scene) : scene_(scene) {}

    Plan make()
    {
        findUsed();
        shapes();
        surfaces();
        rays();
        lights();
        sky();
        form();
        for (const auto& feature : plan_.features)
            if (feature.in)
                plan_.defines.insert(feature.defines.begin(), feature.defines.end());
        return std::move(plan_);
    }

private:
    void add(const std::string& name, bool in, const std::string& whyIn, const std::string& whyOut,
             std::vector<std::string> defines)
    {
        plan_.features.push_back({name, in, in ? whyIn : whyOut, std::move(defines)});
    }

    // Names of the used materials for which `holds`, for a reason.
    std::string materialsWith(const std::function<bool(const Material&)>& holds) const
    {
        std::vector<std::string> names;
        for (const auto i : plan_.materials)
            if (holds(scene_.materials[i]))
                names.push_back(scene_.materials[i].name);
        return join(names, ", ");
    }

    void addForMaterials(const std::string& name, const std::function<bool(const Material&)>& holds,
                         const std::string& whyOut, std::vector<std::string> defines)
    {
        const auto names = materialsWith(holds);
        add(name, !names.empty(), "material " + names, whyOut, std::move(defines));
    }

    void findUsed()
    {
        std::set<std::size_t> used;
        for (const auto& object : scene_.objects)
            used.insert(object.material);
        if (scene_.camera.inside)
            used.insert(*scene_.camera.inside);
        // The media outside of used materials matter to absorption.
        for (std::size_t pass = 0; pass < scene_.materials.size(); ++pass)
            for (const auto i : std::set<std::size_t>(used))
                if (scene_.materials[i].outside)
                    used.insert(*scene_.materials[i].outside);
        plan_.materials = {used.begin(), used.end()};
        for (std::size_t i = 0; i < scene_.objects.size(); ++i)
            if (scene_.materials[scene_.objects[i].material].light)
                plan_.glowing.push_back(i);
        for (std::size_t i = 0; i < scene_.lights.size(); ++i)
            if (scene_.lights[i].kind != Light::Kind::ambient)
                plan_.placedLights.push_back(i);
    }

    template <typename Shape>
    std::string countOf(const std::function<bool(const Shape&)>& holds = [](const Shape&) {
        return true;
    }) const
    {
        const auto count =
            std::count_if(scene_.objects.begin(), scene_.objects.end(), [&](const Object& object) {
                const auto* shape = std::get_if<Shape>(&object.primitive);
                return shape != nullptr && holds(*shape);
            });
        return count == 0 ? "" : fmt::format("{} object{}", count, count == 1 ? "" : "s");
    }

    void shape(const std::string& name, const std::string& count, std::vector<std::string> defines)
    {
        add(name, !count.empty(), count, "no such object", std::move(defines));
    }

    void shapes()
    {
        add("objects", !scene_.objects.empty(), fmt::format("{} in all", scene_.objects.size()),
            "the scene is empty", {"HAS_OBJECTS"});
        shape("sphere", countOf<Sphere>(), {"HAS_SPHERE"});
        shape("open cylinder", countOf<Cylinder>([](const auto& c) { return !c.capped; }),
              {"HAS_CYLINDER", "HAS_OPEN_CYLINDER"});
        shape("capped cylinder", countOf<Cylinder>([](const auto& c) { return c.capped; }),
              {"HAS_CYLINDER", "HAS_CAPPED_CYLINDER"});
        shape("plane", countOf<Plane>(), {"HAS_PLANE"});
        shape("disk", countOf<Disk>(), {"HAS_DISK"});
        shape("rectangle", countOf<Rectangle>(), {"HAS_RECTANGLE"});
        shape("triangle", countOf<Triangle>(), {"HAS_TRIANGLE"});
    }

    // Materials of objects alone: a medium around the camera has no surface.
    bool onObject(const Material& material) const
    {
        return std::any_of(scene_.objects.begin(), scene_.objects.end(),
                           [&](const Object& o) { return &scene_.materials[o.material] == &material; });
    }

    // Whether anything but mirrored and transmitted light is seen of a surface.
    static bool hasLocal(const Material& material)
    {
        return material.mirror < 1.0 && material.transmit < 1.0;
    }

    // Whether any light falls on the scene at all; without, no surface's colour is ever asked for.
    bool anythingShines() const
    {
        const bool everywhere = std::ranges::any_of(
            scene_.lights, [](const Light& light) { return light.ambient != glm::dvec3(0.0); });
        return everywhere || !plan_.placedLights.empty() || !plan_.glowing.empty();
    }

    void surfaces()
    {
        const bool lit = anythingShines();
        const auto seen = [this, lit](const Material& m) { return lit && onObject(m) && hasLocal(m); };
        addForMaterials("picture", [&](const auto& m) { return seen(m) && !m.image.empty(); },
                        "no lit material has an image", {"HAS_PICTURES", "HAS_COORDINATES"});
        addForMaterials("checker", [&](const auto& m) { return seen(m) && m.checker; },
                        "no lit material has a pattern", {"HAS_CHECKER", "HAS_COORDINATES"});
        addForMaterials("emission",
                        [&](const auto& m) { return onObject(m) && m.emission != glm::dvec3(0.0); },
                        "no material glows", {"HAS_EMISSION"});
        for (const auto i : plan_.materials) {
            const auto& material = scene_.materials[i];
            const PictureUse use{material.image, material.encoding};
            if (seen(material) && !material.image.empty() && std::ranges::count(plan_.pictures, use) == 0)
                plan_.pictures.push_back(use);
        }
    }

    void rays()
    {
        addForMaterials("mirror", [&](const auto& m) { return onObject(m) && m.mirror > 0.0; },
                        "no material mirrors", {"HAS_MIRROR_RAY"});
        addForMaterials("refraction",
                        [&](const auto& m) { return onObject(m) && m.transmit > 0.0 && m.mirror < 1.0; },
                        "no material transmits light", {"HAS_MIRROR_RAY", "HAS_REFRACTION"});
        const bool refracts = plan_.has("refraction");
        const bool swims = scene_.camera.inside.has_value();
        const auto absorbing = materialsWith([](const auto& m) { return m.absorption != glm::dvec3(0.0); });
        add("absorption", !absorbing.empty() && (refracts || swims), "material " + absorbing,
            absorbing.empty() ? "no medium absorbs" : "no ray gets into a medium", {"HAS_ABSORPTION"});
        const bool sendsOn = refracts || plan_.has("mirror");
        add("depth limit", sendsOn && scene_.trace.depth.has_value(), "trace.depth is set",
            sendsOn ? "trace.depth is not set" : "no ray is sent on", {"HAS_DEPTH_LIMIT"});
        rayTree(sendsOn, refracts);
    }

    // How many interfaces lie within each other: the longest chain of `outside`, counted from air.
    int nesting() const
    {
        int deepest = 0;
        for (const auto i : plan_.materials) {
            int depth = 0;
            std::optional<std::size_t> medium = i;
            while (medium && scene_.materials[*medium].transmit > 0.0) {
                ++depth;
                medium = scene_.materials[*medium].outside;
            }
            deepest = std::max(deepest, depth);
        }
        return deepest;
    }

    void rayTree(bool sendsOn, bool refracts)
    {
        const int nested = nesting();
        plan_.budget = sendsOn ? scene_.trace.budget.value_or(16 + 8 * std::max(0, nested - 1)) : 1;
        plan_.poolSlots = nested > 1 ? 4 : 3;
        const bool breadthFirst = scene_.trace.order == TreeOrder::breadthFirst;
        plan_.tree = !sendsOn       ? RayTree::single
                     : breadthFirst ? RayTree::breadthFirst
                     : refracts     ? RayTree::heaviestFirst
                                    : RayTree::chain;
        const std::string never = sendsOn ? "no surface both reflects and refracts" : "no ray is sent on";
        add("ray chain", plan_.tree == RayTree::chain, "surfaces send on one ray each",
            sendsOn ? "a surface splits rays, or trace.order asks for a queue" : "no ray is sent on", {});
        add("ray pool", plan_.tree == RayTree::heaviestFirst,
            fmt::format("{} slots: {}", plan_.poolSlots,
                        nested > 1 ? "media lie within each other" : "surfaces reflect and refract"),
            breadthFirst && sendsOn ? "trace.order is breadth-first" : never, {});
        add("ray queue", plan_.tree == RayTree::breadthFirst, "trace.order is breadth-first",
            sendsOn ? "trace.order is heaviest-first" : never, {});
    }

    std::string lightsWith(const std::function<bool(const Light&)>& holds) const
    {
        const auto count = std::count_if(scene_.lights.begin(), scene_.lights.end(), holds);
        return count == 0 ? "" : fmt::format("{} light{}", count, count == 1 ? "" : "s");
    }

    void addForLights(const std::string& name, const std::function<bool(const Light&)>& holds,
                      std::string whyOut, std::vector<std::string> defines)
    {
        const auto lights = lightsWith(holds);
        const bool in = lit_ && !lights.empty();
        add(name, in, lights, lit_ ? std::move(whyOut) : "no surface shows light that falls on it",
            std::move(defines));
    }

    void lights()
    {
        const auto type = scene_.trace.lightType;
        const auto typeIs = fmt::format("trace.light_type is {}", static_cast<int>(type));
        add("unlit colours", type == LightType::unlit, typeIs + ": one ambient light stands for all", typeIs,
            {});
        add("lights alone", type == LightType::lightsOnly, typeIs + ": no ambient light, black sky", typeIs,
            {});
        const bool shows =
            !materialsWith([this](const auto& m) { return onObject(m) && hasLocal(m); }).empty();
        lit_ = shows && anythingShines();
        using Kind = Light::Kind;
        add("local shading", lit_, "some surface shows light that falls on it",
            shows ? "nothing shines" : "every surface is a mirror or glass", {"HAS_LOCAL"});
        addForLights("ambient light",
                     [](const Light& l) {
                         return (l.kind == Kind::ambient || l.kind == Kind::directional) &&
                                l.ambient != glm::dvec3(0.0);
                     },
                     "no light shines from everywhere", {"HAS_AMBIENT", "HAS_ANY_AMBIENT"});
        addForLights("ambient part of placed lights",
                     [](const Light& l) {
                         return (l.kind == Kind::point || l.kind == Kind::spot) &&
                                l.ambient != glm::dvec3(0.0);
                     },
                     "no point or spot light has one", {"HAS_LIGHT_AMBIENT", "HAS_ANY_AMBIENT"});
        addForLights("directional light", [](const Light& l) { return l.kind == Kind::directional; },
                     "no such light", {"HAS_LIGHTS"});
        addForLights("point light", [](const Light& l) { return l.kind == Kind::point; }, "no such light",
                     {"HAS_LIGHTS", "HAS_PLACED_LIGHT"});
        addForLights("spot light", [](const Light& l) { return l.kind == Kind::spot; }, "no such light",
                     {"HAS_LIGHTS", "HAS_PLACED_LIGHT", "HAS_SPOT_LIGHT"});
        add("glowing sphere", lit_ && !plan_.glowing.empty(),
            fmt::format("{} of the objects", plan_.glowing.size()), "no material has light = true",
            {"HAS_LIGHTS", "HAS_PLACED_LIGHT"});
        if (!lit_) {
            plan_.placedLights.clear();
            plan_.glowing.clear();
        }
        const bool anyLight = !plan_.placedLights.empty() || !plan_.glowing.empty();
        highlights(anyLight);
        shadows(anyLight);
    }

    void highlights(bool anyLight)
    {
        const auto with = [this](ReflectanceModel model) {
            return [this, model](const Material& m) {
                return onObject(m) && hasLocal(m) && m.model == model && m.specular != glm::dvec3(0.0);
            };
        };
        const auto addModel = [&](const std::string& name, ReflectanceModel model,
                                  const std::string& define) {
            const auto names = materialsWith(with(model));
            add(name, anyLight && !names.empty(), "material " + names,
                anyLight ? "no visible material of this model has a highlight" : "no light to reflect",
                {define, "HAS_HIGHLIGHT"});
        };
        addModel("Phong highlight", ReflectanceModel::phong, "HAS_PHONG");
        addModel("Blinn highlight", ReflectanceModel::blinn, "HAS_BLINN");
    }

    void shadows(bool anyLight)
    {
        const auto casting =
            materialsWith([this](const auto& m) { return onObject(m) && m.shadow != ShadowKind::none; });
        add("shadows", anyLight && !casting.empty(), "a light shines and objects stand in its way",
            anyLight ? "nothing casts a shadow" : "no light to shade", {"HAS_SHADOWS"});
        const auto tinting = materialsWith([this](const auto& m) {
            return onObject(m) && m.shadow == ShadowKind::tinted && m.transmit > 0.0 && m.mirror < 1.0;
        });
        add("tinted shadows", anyLight && !tinting.empty(), "material " + tinting,
            anyLight ? "nothing transparent casts a shadow" : "no light to shade", {"HAS_TINTED_SHADOWS"});
    }

    void sky()
    {
        add("sky gradient", scene_.sky.kind == Sky::Kind::gradient, "sky.gradient", "the sky has none",
            {"HAS_SKY_GRADIENT"});
        add("sky picture", scene_.sky.kind == Sky::Kind::image, scene_.sky.image, "the sky has none",
            {"HAS_SKY_PICTURE"});
    }

    void form()
    {
        plan_.form = scene_.trace.form;
        const bool literal = plan_.form == SceneForm::literal;
        add("literal geometry", literal, "geometry as constants", "trace.form is loop", {});
        add("geometry table", !literal, "trace.form is loop", "geometry is literal", {});
    }

    const Scene& scene_;
    Plan plan_;
    bool lit_ = false; // some surface shows light that falls on it
};

} // namespace

const Feature& Plan::feature(const std::string& name) const
{
    const auto found =
        std::find_if(features.begin(), features.end(), [&](const Feature& f) { return f.name == name; });
    if (found == features.end())
        throw std::logic_error("the plan has no feature called " + name);
    return *found;
}

Plan makePlan(const Scene& scene)
{
    return Planner(scene).make();
}

} // namespace dioptre
