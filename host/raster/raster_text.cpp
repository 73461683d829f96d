#include "raster/raster_text.h"

#include "raster/raster_plan.h"
#include "render/assemble.h"
#include "render/device_scene.h"
#include "render/picture_groups.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

// A light of the packed scene, as generated text calls it.
struct LightName {
    int index;
    std::string light;     // "u_lights[2]"
    std::string incidence; // "incidence2"
    std::string arrives;   // "pointIncidence(u_lights[2], surface.position)"
    bool parallel;         // shines from no place
    bool placed;           // has an ambient part of its own
    int glowing;           // the object that glows, -1 for none
};

std::vector<LightName> lightNames(const PackedScene& packed)
{
    std::vector<LightName> names;
    for (int i = 0; i < static_cast<int>(packed.lights.size()); ++i) {
        const bool directional = i < packed.firstPoint;
        const bool glows = i >= packed.firstGlow;
        const char* kind = directional ? "directional" : glows || i < packed.firstSpot ? "point" : "spot";
        const auto light = fmt::format("u_lights[{}]", i);
        const int glowing = static_cast<int>(packed.lights[static_cast<std::size_t>(i)].diffuse.w);
        names.push_back(
            {i, light, fmt::format("incidence{}", i),
             fmt::format("{}Incidence({}{})", kind, light, directional ? "" : ", surface.position"),
             directional, !directional && !glows, glowing});
    }
    return names;
}

bool has(const RasterScene& raster, const char* define)
{
    return raster.prepared.plan.defines.contains(define);
}

bool isLitBefore(const RasterScene& raster)
{
    return has(raster, "HAS_LIT_FACETS") || has(raster, "HAS_LIT_VERTICES");
}

// The share of a light that its map and the planes let through.
std::string shadowText(const RasterScene& raster, const LightName& light)
{
    const auto& views = raster.shadows.lights[static_cast<std::size_t>(light.index)];
    std::string text =
        fmt::format("{}({}, surface.position, facing, {}.towards)",
                    views.count == 1 ? "seesLight" : "seesLightAllAround", views.first, light.incidence);
    if (has(raster, "HAS_SHADING_PLANES"))
        text += fmt::format(" * passesPlanes(surface.position, vec4({}, {}))",
                            light.parallel ? light.incidence + ".towards" : light.light + ".position.xyz",
                            light.parallel ? "0.0" : "1.0");
    return text;
}

// lightVertex(): what the vertex stage hands on of every light.
std::string vertexLights(const RasterScene& raster)
{
    const bool shiny = has(raster, "HAS_HIGHLIGHT");
    const bool ambient = has(raster, "HAS_LIGHT_AMBIENT");
    const int parts = litParts(raster.prepared.plan);
    std::string text =
        "// What each light sends to the eye from there.\n"
        "void lightVertex(vec3 position, vec3 normal)\n{\n"
        "    Material material = drawnMaterial();\n"
        "    Surface surface;\n    surface.position = position;\n    surface.normal = normal;\n"
        "    surface.colour = vec3(1.0);\n"
        "    Ray ray;\n    ray.origin = u_camera.eye.xyz;\n"
        "    ray.direction = normalize(position - u_camera.eye.xyz);\n    ray.from = -1;\n";
    if (ambient)
        text += "    v_ambient = vec3(0.0);\n";
    for (const auto& light : lightNames(raster.prepared.packed)) {
        const int part = parts > 1 ? light.index : 0;
        const char* sum = part == light.index ? "=" : "+=";
        text += fmt::format("    Incidence {} = {};\n", light.incidence, light.arrives);
        text += fmt::format("    Lit lit{} = litBy({}, {}, {}, surface, material, ray);\n", light.index,
                            light.light, light.incidence, light.glowing);
        text += fmt::format("    v_matt[{0}] {1} lit{2}.matt;\n", part, sum, light.index);
        if (shiny)
            text += fmt::format("    v_shine[{0}] {1} lit{2}.shine;\n", part, sum, light.index);
        if (ambient && light.placed)
            text +=
                fmt::format("    v_ambient += {}.strength * {}.ambient.xyz;\n", light.incidence, light.light);
    }
    return text + "}\n\n";
}

std::string signature(const RasterScene& raster)
{
    return fmt::format("// Radiance towards the viewer from every light.\n"
                       "vec3 lightsReflected(Surface surface, Material material, Ray ray{})\n{{\n"
                       "    vec3 radiance = vec3(0.0);\n",
                       has(raster, "HAS_SHADOW_MAPS") ? ", vec3 facing" : "");
}

// lightsReflected() where light is known from the vertex stage, but for its shadows.
std::string litBeforeText(const RasterScene& raster)
{
    std::string text = signature(raster);
    const int parts = litParts(raster.prepared.plan);
    const char* shine = has(raster, "HAS_HIGHLIGHT") ? " + v_shine[{0}]" : "";
    const auto lights = lightNames(raster.prepared.packed);
    for (int part = 0; part < parts; ++part) {
        std::string share;
        if (castsShadows(raster.prepared.plan)) {
            const auto& light = lights[static_cast<std::size_t>(part)];
            text += fmt::format("    Incidence {} = {};\n", light.incidence, light.arrives);
            share = shadowText(raster, light) + " * ";
        }
        text += fmt::format("    radiance += {}(v_matt[{}] * surface.colour{});\n", share, part,
                            fmt::format(fmt::runtime(shine), part));
    }
    if (has(raster, "HAS_LIGHT_AMBIENT"))
        text += "    radiance += v_ambient * ambientColour(surface, material);\n";
    return text + "    return radiance;\n}\n\n";
}

// lightsReflected() where each pixel is lit.
std::string litHereText(const RasterScene& raster)
{
    std::string text = signature(raster);
    for (const auto& light : lightNames(raster.prepared.packed)) {
        text += fmt::format("    Incidence {} = {};\n", light.incidence, light.arrives);
        if (has(raster, "HAS_LIGHT_AMBIENT") && light.placed)
            text += fmt::format("    radiance += ambientReflected({}, {}, surface, material);\n", light.light,
                                light.incidence);
        if (castsShadows(raster.prepared.plan))
            text += fmt::format("    {}.strength *= {};\n", light.incidence, shadowText(raster, light));
        text += fmt::format("    radiance += lightReflected({}, {}, {}, surface, material, ray, 0, "
                            "u_side < 0.0);\n",
                            light.light, light.incidence, light.glowing);
    }
    return text + "    return radiance;\n}\n\n";
}

class Assembler
{
public:
    Assembler(const RasterScene& raster, const std::filesystem::path& folder)
        : raster_(raster), folder_(folder)
    {
    }

    SourceText operator()(const char* file, const std::string& lights = "") const
    {
        const auto& [scene, plan, packed, parts] = raster_.prepared;
        PreprocessInput input;
        input.search.folders = {folder_};
        input.features = plan.defines;
        input.generated["generated/scene.glsl"] = linesOf(
            (plan.has("picture") ? picturesText(plan, packed) : "") + "#include \"raster/object.glsl\"\n",
            "generated");
        input.generated["generated/lights.glsl"] = linesOf(lights, "generated");
        SourceText body = linesOf(
            fmt::format(
                "#define LIT_COUNT {}\n#define SHADOW_VIEW_COUNT {}\n#define SHADING_PLANE_COUNT {}\n\n",
                litParts(plan), std::max<std::size_t>(1, raster_.shadows.views.size()),
                std::max<std::size_t>(1, raster_.shadows.planes.size())),
            "generated");
        const SourceText source = readSource(folder_ / "raster" / file);
        body.insert(body.end(), source.begin(), source.end());
        return assembled(plan, packed, body, input);
    }

private:
    const RasterScene& raster_;
    const std::filesystem::path& folder_;
};

std::vector<std::string> fedToSurface(const RasterScene& raster)
{
    const Plan& plan = raster.prepared.plan;
    std::vector<std::string> fed = {"CameraBlock",    "ObjectBlock",      "u_resolution",
                                    "u_sample_first", "u_tile_origin_px", "u_near_m"};
    const bool lit = has(raster, "HAS_LIGHTS");
    const bool mirrors = has(raster, "HAS_MIRROR_RAY");
    // Whatever a mirror under a plain sky shows is the same.
    const bool mirrorsDirections =
        mirrors && (plan.has("refraction") || plan.has("sky gradient") || plan.has("sky picture"));
    if (lit || mirrorsDirections || plan.has("picture"))
        fed.emplace_back("u_side");
    if (lit)
        fed.emplace_back("LightBlock");
    if (has(raster, "HAS_AMBIENT"))
        fed.emplace_back("u_ambient");
    if (mirrors)
        fed.emplace_back("SkyBlock");
    for (const auto& texture : plannedTextures(plan, raster.prepared.packed))
        if (texture != "u_sky_picture" || mirrors)
            fed.push_back(texture);
    if (has(raster, "HAS_EYE_MEDIUM"))
        fed.emplace_back("u_eye_absorption");
    if (castsShadows(plan))
        fed.insert(fed.end(), {"ShadowBlock", "u_shadow_maps", "u_shadow_bias"});
    return fed;
}

std::vector<std::string> fedToSky(const Plan& plan)
{
    std::vector<std::string> fed = {"SkyBlock", "CameraBlock"};
    if (plan.has("sky gradient") || plan.has("sky picture"))
        fed.insert(fed.end(), {"u_resolution", "u_tile_origin_px", "u_sample_first"});
    if (plan.has("sky picture"))
        fed.emplace_back("u_sky_picture");
    if (plan.defines.contains("HAS_EYE_MEDIUM"))
        fed.emplace_back("u_eye_absorption");
    return fed;
}

} // namespace

std::vector<RasterText> textsOfAll(const RasterTexts& texts)
{
    std::vector<RasterText> all;
    for (const RasterText* text : {&texts.surface, &texts.sky, &texts.caster, &texts.wire, &texts.add})
        if (!text->fragment.empty())
            all.push_back(*text);
    return all;
}

std::vector<std::string> rasterSources()
{
    std::vector<std::string> sources;
    for (const char* file : {"surface.vert", "surface.frag", "sky.frag", "caster.vert", "caster.frag",
                             "wire.vert", "wire.frag", "add.frag"})
        sources.push_back(std::string("raster/") + file);
    return sources;
}

RasterTexts rasterTexts(const RasterScene& raster, const std::filesystem::path& glslFolder)
{
    const Assembler assemble(raster, glslFolder);
    const Plan& plan = raster.prepared.plan;
    const bool lit = has(raster, "HAS_LIGHTS");
    RasterTexts texts;
    texts.sky = {{}, assemble("sky.frag"), fedToSky(plan)};
    texts.add = {{}, assemble("add.frag"), {"u_sample", "u_sample_origin_px"}};
    if (plan.has("objects"))
        texts.wire = {
            assemble("wire.vert"),
            assemble("wire.frag"),
            {"CameraBlock", "ObjectBlock", "u_resolution", "u_tile_origin_px", "u_sample_first", "u_near_m"}};
    if (plan.has("objects"))
        texts.surface = {assemble("surface.vert", isLitBefore(raster) ? vertexLights(raster) : ""),
                         assemble("surface.frag", !lit                  ? ""
                                                  : isLitBefore(raster) ? litBeforeText(raster)
                                                                        : litHereText(raster)),
                         fedToSurface(raster)};
    if (castsShadows(plan))
        texts.caster = {assemble("caster.vert"),
                        assemble("caster.frag"),
                        {"ObjectBlock", "ShadowBlock", "u_shadow_view"}};
    return texts;
}

} // namespace dioptre
