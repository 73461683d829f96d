#include "render/shared_values.h"

#include <glad/gl.h>

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// Where a value travels: its vec4 and its first component there.
struct Place {
    int vector = 0;
    int first = 0;
};

// Each takes the first vec4 that has room for it.
std::vector<Place> placesOf(const std::vector<SharedValue>& values)
{
    std::vector<Place> places;
    std::vector<int> taken; // components of each vec4
    for (const auto& value : values) {
        std::size_t vector = 0;
        while (vector < taken.size() && taken[vector] + value.components > 4)
            ++vector;
        if (vector == taken.size())
            taken.push_back(0);
        places.push_back({static_cast<int>(vector), taken[vector]});
        taken[vector] += value.components;
    }
    return places;
}

// "v_shared[3].yz"
std::string textOf(const Place& place, int components)
{
    const std::string all = "xyzw";
    return fmt::format("v_shared[{}]{}", place.vector,
                       components == 4 ? ""
                                       : "." + all.substr(static_cast<std::size_t>(place.first),
                                                          static_cast<std::size_t>(components)));
}

} // namespace

std::vector<SharedValue> sharedView(const Plan& plan)
{
    const auto has = [&](const char* define) { return plan.defines.contains(define); };
    std::vector<SharedValue> values = {
        {"u_camera.eye", 4}, {"u_camera.right.xyz", 3}, {"u_camera.up.xyz", 3}, {"u_camera.forward", 4}};
    if (seesDirections(plan)) {
        values.push_back({"u_resolution", 2});
        values.push_back({"u_tile_origin_px", 2});
    }
    if (!showsFirstHit(plan.view))
        values.push_back({"u_sky.colour.xyz", 3});
    if (has("HAS_SKY_GRADIENT")) {
        values.push_back({"u_sky.horizon.xyz", 3});
        values.push_back({"u_sky.zenith.xyz", 3});
    }
    if (has("HAS_SKY_PICTURE"))
        values.push_back({"u_sky.turn.xyz", 3});
    if (plan.tree != RayTree::single) {
        values.push_back({"u_budget", 1, true});
        values.push_back({"u_cut_off", 1});
    }
    if (has("HAS_AMBIENT"))
        values.push_back({"u_ambient", 3});
    return values;
}

std::vector<SharedValue> sharedLights(const Scene& scene, const Plan& plan)
{
    std::vector<SharedValue> values;
    const auto has = [&](const char* define) { return plan.defines.contains(define); };
    for (std::size_t i = 0; i < plan.placedLights.size() + plan.glowing.size(); ++i) {
        const bool glows = i >= plan.placedLights.size();
        const auto kind = glows ? Light::Kind::point : scene.lights[plan.placedLights[i]].kind;
        const auto add = [&](const char* member, int components) {
            values.push_back({fmt::format("u_lights[{}].{}", i, member), components});
        };
        add("diffuse.xyz", 3);
        if (has("HAS_HIGHLIGHT"))
            add("specular.xyz", 3);
        if (kind == Light::Kind::directional || kind == Light::Kind::spot)
            add("direction", 4);
        if (kind == Light::Kind::directional)
            continue;
        add("position.xyz", 3);
        add("specular.w", 1);
        add("attenuation.xyz", 3);
        if (has("HAS_LIGHT_AMBIENT") && !glows)
            add("ambient.xyz", 3);
        if (kind == Light::Kind::spot)
            add("ambient.w", 1);
    }
    return values;
}

int vectorsOf(const std::vector<SharedValue>& values)
{
    int count = 0;
    for (const auto& place : placesOf(values))
        count = std::max(count, place.vector + 1);
    return count;
}

std::string shareDeclaration(const std::vector<SharedValue>& values)
{
    return fmt::format("flat out vec4 v_shared[{}];\n", vectorsOf(values));
}

std::string shareStatements(const std::vector<SharedValue>& values)
{
    std::string text;
    const auto places = placesOf(values);
    for (std::size_t i = 0; i < values.size(); ++i)
        text += fmt::format("    {} = {};\n", textOf(places[i], values[i].components),
                            values[i].isInt ? fmt::format("float({})", values[i].name) : values[i].name);
    return text;
}

std::string receiveText(const std::vector<SharedValue>& values)
{
    if (values.empty())
        return "";
    std::string text =
        fmt::format("flat in vec4 v_shared[{}];\n\n// Once for each pixel, before anything else.\n"
                    "void receiveShared()\n{{\n",
                    vectorsOf(values));
    const auto places = placesOf(values);
    for (std::size_t i = 0; i < values.size(); ++i) {
        const auto place = textOf(places[i], values[i].components);
        // Materials that are read by index stay in their block, under their own name.
        auto name = values[i].name;
        if (name.starts_with("u_materials"))
            name.replace(0, 1, "shared");
        text += fmt::format("    {} = {};\n", name,
                            values[i].isInt ? fmt::format("int({} + 0.5)", place) : place);
    }
    return text + "}\n";
}

} // namespace dioptre
