#include "render/planner.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace dioptre
{

std::string Planner::lightsWith(const std::function<bool(const Light&)>& holds) const
{
    const auto count = std::count_if(scene_.lights.begin(), scene_.lights.end(), holds);
    return count == 0 ? "" : fmt::format("{} light{}", count, count == 1 ? "" : "s");
}

void Planner::addForLights(const std::string& name, const std::function<bool(const Light&)>& holds,
                           std::string whyOut, std::vector<std::string> defines)
{
    const auto lights = lightsWith(holds);
    const bool in = lit_ && !lights.empty();
    add(name, in, lights, lit_ ? std::move(whyOut) : "no surface shows light that falls on it",
        std::move(defines));
}

void Planner::lights()
{
    const auto type = scene_.trace.lightType;
    const auto typeIs = fmt::format("trace.light_type is {}", static_cast<int>(type));
    add("unlit colours", type == LightType::unlit, typeIs + ": one ambient light stands for all", typeIs, {});
    add("lights alone", type == LightType::lightsOnly, typeIs + ": no ambient light, black sky", typeIs, {});
    const bool shows = !materialsWith([this](const auto& m) { return isSeen(m) && hasLocal(m); }).empty();
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
                     return (l.kind == Kind::point || l.kind == Kind::spot) && l.ambient != glm::dvec3(0.0);
                 },
                 "no point or spot light has one", {"HAS_LIGHT_AMBIENT", "HAS_ANY_AMBIENT"});
    addForLights("directional light", [](const Light& l) { return l.kind == Kind::directional; },
                 "no such light", {"HAS_LIGHTS", "HAS_DIRECTIONAL_LIGHT"});
    addForLights("point light", [](const Light& l) { return l.kind == Kind::point; }, "no such light",
                 {"HAS_LIGHTS", "HAS_PLACED_LIGHT", "HAS_POINT_LIGHT"});
    addForLights("spot light", [](const Light& l) { return l.kind == Kind::spot; }, "no such light",
                 {"HAS_LIGHTS", "HAS_PLACED_LIGHT", "HAS_SPOT_LIGHT"});
    add("glowing sphere", lit_ && !plan_.glowing.empty(),
        fmt::format("{} of the objects", plan_.glowing.size()), "no material has light = true",
        {"HAS_LIGHTS", "HAS_PLACED_LIGHT", "HAS_GLOW"});
    if (!lit_) {
        plan_.placedLights.clear();
        plan_.glowing.clear();
    }
    const bool anyLight = !plan_.placedLights.empty() || !plan_.glowing.empty();
    highlights(anyLight);
    shadows(anyLight);
}

void Planner::highlights(bool anyLight)
{
    const auto with = [this](ReflectanceModel model) {
        return [this, model](const Material& m) {
            return isSeen(m) && hasLocal(m) && m.model == model && canShine(m);
        };
    };
    const auto addModel = [&](const std::string& name, ReflectanceModel model, const std::string& define) {
        const auto names = materialsWith(with(model));
        add(name, anyLight && !names.empty(), "material " + names,
            anyLight ? "no visible material of this model has a highlight" : "no light to reflect",
            {define, "HAS_HIGHLIGHT"});
    };
    addModel("Phong highlight", ReflectanceModel::phong, "HAS_PHONG");
    addModel("Blinn highlight", ReflectanceModel::blinn, "HAS_BLINN");
    addModel("microfacets", ReflectanceModel::microfacet, "HAS_MICROFACET");
}

void Planner::shadows(bool anyLight)
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
    const auto absorbing = materialsWith([](const auto& m) { return m.absorption != glm::dvec3(0.0); });
    add("absorption in shadows", anyLight && !tinting.empty() && !absorbing.empty(), "material " + absorbing,
        !anyLight         ? "no light to shade"
        : tinting.empty() ? "nothing transparent casts a shadow"
                          : "no medium absorbs",
        {"HAS_SHADOW_ABSORPTION"});
}

void Planner::sky()
{
    add("sky gradient", scene_.sky.kind == Sky::Kind::gradient, "sky.gradient", "the sky has none",
        {"HAS_SKY_GRADIENT"});
    add("sky picture", scene_.sky.kind == Sky::Kind::image,
        std::filesystem::path(scene_.sky.image).filename().string(), "the sky has none", {"HAS_SKY_PICTURE"});
}

} // namespace dioptre
