#include "raster/raster_plan.h"

#include "raster/raster_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace dioptre
{
namespace
{

// Rows of the tracer's plan that are of rays, and of the ways that values reach them.
const std::set<std::string>& rowsOfRays()
{
    static const std::set<std::string> names = {
        "view",
        "depth limit",
        "ray chain",
        "ray pool",
        "ray queue",
        "ray stack",
        "shadows",
        "tinted shadows",
        "absorption in shadows",
        "light loops",
        "shared view",
        "shared lights",
        "shared materials",
        "literal geometry",
        "surfaces by selects",
        "compensated kernels",
        "kernels by curvature",
        "solids seen from within",
    };
    return names;
}

class RasterPlanner
{
public:
    RasterPlanner(const PreparedScene& prepared, const Method& method)
        : scene_(typicalOf(prepared.scene)), method_(method), plan_(prepared.plan)
    {
        plan_.readsMaterials = false; // each object brings its own
        std::erase_if(plan_.features, [](const Feature& f) { return rowsOfRays().contains(f.name); });
        lights_ = plan_.placedLights.size() + plan_.glowing.size();
    }

    Plan make()
    {
        add("rasterised", true, fmt::format("--method {}", nameOf(method_)), {});
        shadows();
        medium();
        lighting();
        mirrors();
        planes();
        asObjects();
        plan_.defines.clear();
        for (const auto& feature : plan_.features)
            if (feature.in)
                plan_.defines.insert(feature.defines.begin(), feature.defines.end());
        return std::move(plan_);
    }

private:
    void add(const std::string& name, bool in, const std::string& reason, std::vector<std::string> defines)
    {
        plan_.features.push_back({name, in, reason, std::move(defines)});
    }

    bool in(const char* feature) const
    {
        return plan_.has(feature);
    }

    void shadows()
    {
        const auto& raster = scene_.raster;
        const bool casts = std::ranges::any_of(scene_.objects, [&](const Object& object) {
            return scene_.materials[object.material].shadow == ShadowKind::opaque;
        });
        const bool maps = lights_ > 0 && casts && raster.shadowMap_px > 0;
        add("shadow maps", maps,
            maps           ? fmt::format("raster.shadow_map: {0} x {0} texels", raster.shadowMap_px)
            : lights_ == 0 ? "no light to shade"
            : !casts       ? "nothing opaque casts a shadow"
                           : "raster.shadow_map is 0",
            {"HAS_SHADOW_MAPS"});
        const bool filter = maps && raster.shadowFilter == Raster::ShadowFilter::percentage;
        add("percentage-closer filter", filter,
            filter ? "raster.shadow_filter is pcf"
            : maps ? "raster.shadow_filter is nearest"
                   : "there is no shadow map",
            {"HAS_SHADOW_FILTER"});
    }

    // What an eye within a medium loses on the way.
    void medium()
    {
        const auto& inside = scene_.camera.inside;
        const bool absorbs = inside && scene_.materials[*inside].absorption != glm::dvec3(0.0);
        add("absorption before the eye", absorbs,
            absorbs ? "the eye is in " + scene_.materials[*inside].name
                    : "the eye is in nothing that absorbs",
            {"HAS_EYE_MEDIUM"});
        const bool planes =
            in("shadow maps") && std::ranges::any_of(scene_.objects, [&](const Object& object) {
                return std::holds_alternative<Plane>(object.primitive) &&
                       scene_.materials[object.material].shadow == ShadowKind::opaque;
            });
        add("shading planes", planes,
            planes ? "what is behind one is dark: no map holds a plane" : "no plane casts a shadow",
            {"HAS_SHADING_PLANES"});
    }

    // What comes from the vertex stage, and whether it is mixed between the corners.
    void lighting()
    {
        const bool facets = method_.shading == Shading::flat;
        const bool vertices = method_.shading == Shading::gouraud;
        const bool shiny = in("Phong highlight") || in("Blinn highlight") || in("microfacets");
        std::vector<std::string> defines;
        const auto define = [&](bool wanted, const std::string& what) {
            if (wanted && (facets || vertices))
                defines.push_back("HAS_" + what + (facets ? "_FACETS" : "_VERTICES"));
        };
        define(lights_ > 0, "LIT");
        define(lights_ > 0 && shiny, "SHINY");
        define(lights_ > 0 && in("ambient part of placed lights"), "AMBIENT");
        add("lit facets", facets, facets ? "each is lit in its middle" : "light is found elsewhere",
            facets ? defines : std::vector<std::string>{});
        add("lit vertices", vertices, vertices ? "light is mixed between them" : "light is found elsewhere",
            vertices ? defines : std::vector<std::string>{});
        add("facet normals", facets,
            facets ? "facets have one each" : "normals are mixed between the corners", {"HAS_FACETS"});
    }

    void mirrors()
    {
        const bool mirrors = in("mirror") || in("refraction");
        add("surroundings from the sky", mirrors,
            mirrors ? "mirrors and glass show the sky alone" : "nothing mirrors or is clear", {});
        const bool two = in("refraction") && scene_.raster.interfaces == 2;
        add("two interfaces", two,
            two                ? "raster.interfaces is 2: light is bent on its way out of a solid, too"
            : in("refraction") ? "raster.interfaces is 1"
                               : "no material transmits light",
            {"HAS_TWO_INTERFACES"});
    }

    // Objects are drawn one at a time, and none asks for another.
    void asObjects()
    {
        for (auto& feature : plan_.features)
            if (feature.name == "geometry table")
                feature = {feature.name, false, "objects are drawn one at a time", {}};
    }

    void planes()
    {
        std::vector<std::string> patches;
        for (const auto& object : scene_.objects)
            if (const auto* plane = std::get_if<Plane>(&object.primitive))
                patches.push_back(
                    fmt::format("{}{:.4g} m on a side ({})", object.name.empty() ? "" : object.name + ": ",
                                plane->rasterExtent_m.value_or(usualPatch_m(scene_, *plane)),
                                plane->rasterExtent_m ? "raster_extent_m" : "raster_extent_m sets another"));
        const bool endless = hasEndlessPlanes(method_);
        add("planes to infinity", endless && !patches.empty(),
            patches.empty() ? "no such object"
            : endless       ? "their corners lie at infinity"
                            : "facets and vertices need places to be lit at",
            {});
        add("plane patches", !endless && !patches.empty(),
            patches.empty() ? "no such object"
            : endless       ? "planes have no end"
                            : fmt::format("{}", fmt::join(patches, "; ")),
            {});
    }

    const Scene& scene_;
    const Method method_;
    Plan plan_;
    std::size_t lights_ = 0;
};

} // namespace

Plan rasterPlan(const PreparedScene& prepared, const Method& method)
{
    return RasterPlanner(prepared, method).make();
}

bool castsShadows(const Plan& plan)
{
    return plan.has("shadow maps");
}

int litParts(const Plan& plan)
{
    const auto lights = plan.placedLights.size() + plan.glowing.size();
    return castsShadows(plan) ? static_cast<int>(lights) : 1;
}

} // namespace dioptre
