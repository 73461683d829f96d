#include "render/assemble.h"

#include "base/file.h"
#include "base/text.h"
#include "gl/program.h"
#include "render/literal.h"
#include "render/literal_kernels.h"
#include "render/lookup.h"
#include "render/preprocess.h"
#include "render/prune.h"
#include "render/shared_values.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

// The sizes of the tables, as macros.
std::string countsText(const Plan& plan, const PackedScene& packed)
{
    const auto moving = std::ranges::count_if(packed.objects, [](const auto& o) { return o.moving >= 0; });
    return fmt::format(
        "#define MATERIAL_COUNT {}\n#define FIRST_POINT_LIGHT {}\n#define FIRST_SPOT_LIGHT {}\n"
        "#define FIRST_GLOW {}\n#define LIGHT_COUNT {}\n#define SHAPE_COUNT {}\n#define MOVING_COUNT {}\n"
        "#define POOL_SLOTS {}\n#define QUEUE_SLOTS {}\n\n",
        std::max<std::size_t>(1, packed.materials.size()), packed.firstPoint, packed.firstSpot,
        packed.firstGlow, packed.lights.size(), std::max<std::size_t>(1, packed.objects.size()),
        std::max<std::ptrdiff_t>(1, moving), packed.poolSlots, plan.budget);
}

const char* treeFunction(RayTree tree)
{
    switch (tree) {
    case RayTree::single:
        return "Single";
    case RayTree::chain:
        return "Chain";
    case RayTree::heaviestFirst:
        return "HeaviestFirst";
    case RayTree::breadthFirst:
        return "BreadthFirst";
    case RayTree::depthFirst:
        return "DepthFirst";
    }
    return "";
}

const char* treeFile(RayTree tree)
{
    switch (tree) {
    case RayTree::single:
        return "trace/single.glsl";
    case RayTree::chain:
        return "trace/chain.glsl";
    case RayTree::heaviestFirst:
        return "trace/heaviest_first.glsl";
    case RayTree::breadthFirst:
        return "trace/breadth_first.glsl";
    case RayTree::depthFirst:
        return "trace/depth_first.glsl";
    }
    return "";
}

constexpr const char* firstHitFile = "trace/first_hit.glsl";
constexpr const char* sceneTableFile = "trace/scene_table.glsl";
constexpr const char* sceneLoopFile = "trace/scene_loop.glsl";
constexpr std::array vertexFiles = {"shared/constants.glsl", "shared/structs.glsl", "trace/uniforms.glsl"};

std::string includeText(const char* file)
{
    return fmt::format("#include \"{}\"\n", file);
}

// objectColour(): what the legend says, or a grey that is the object's number plus 1.
std::string objectColoursText(DataView view, std::size_t count)
{
    if (view == DataView::number)
        return "// An object's number, so that 0 is left for nothing.\nvec3 objectColour(int object)\n{\n"
               "    return vec3(float(object) + 1.0);\n}\n\n";
    std::vector<std::string> colours;
    for (std::size_t object = 0; object < count; ++object) {
        const auto [red, green, blue] = objectColour(object);
        colours.push_back(literal(glm::dvec3(red, green, blue) / 255.0));
    }
    return fmt::format(
        "// The colour that stands for an object, as in the legend.\nvec3 objectColour(int object)\n{{\n"
        "    const vec3 colours[{0}] = vec3[{0}](\n        {1});\n    return colours[object];\n}}\n\n",
        count, join(colours, ",\n        "));
}

// traceTree() of a view of what is met first.
std::string firstHitText(const Plan& plan, const PackedScene& packed)
{
    const bool colours =
        (plan.view == DataView::object || plan.view == DataView::number) && !packed.objects.empty();
    return (colours ? objectColoursText(plan.view, packed.objects.size()) : "") + includeText(firstHitFile) +
           "\n// What the view shows of this scene.\n"
           "vec4 traceTree(Path eye)\n{\n    return firstHit(eye);\n}\n\n";
}

std::string treeText(RayTree tree)
{
    return includeText(treeFile(tree)) +
           fmt::format("\n// The ray tree of this scene.\nvec4 traceTree(Path eye)\n{{\n"
                       "    return trace{}(eye);\n}}\n\n",
                       treeFunction(tree));
}

// lightsReflected() as one call a light, or nothing where loops in trace/light.glsl do it.
std::string lightsText(const PackedScene& packed, const Plan& plan)
{
    if (plan.placedLights.size() + plan.glowing.size() == 0 || plan.has("light loops"))
        return "";
    std::string text =
        "// Radiance towards the viewer from every light.\n"
        "vec3 lightsReflected(Surface surface, Material material, Ray ray, int object, bool inside)\n"
        "{\n    vec3 radiance = vec3(0.0);\n";
    for (int i = 0; i < static_cast<int>(packed.lights.size()); ++i) {
        const bool directional = i < packed.firstPoint;
        const bool glows = i >= packed.firstGlow;
        const auto light = fmt::format("u_lights[{}]", i);
        const char* kind = directional ? "directional" : glows || i < packed.firstSpot ? "point" : "spot";
        text += fmt::format("    Incidence incidence{0} = {1}Incidence({2}{3});\n"
                            "    radiance += lightReflected({2}, incidence{0}, {4}, surface, material, ray, "
                            "object, inside);\n",
                            i, kind, light, directional ? "" : ", surface.position",
                            static_cast<int>(packed.lights[static_cast<std::size_t>(i)].diffuse.w));
        if (plan.has("ambient part of placed lights") && !directional && !glows)
            text += fmt::format("    radiance += ambientReflected({}, incidence{}, surface, material);\n",
                                light, i);
    }
    return text + "    return radiance;\n}\n\n";
}

std::string sceneText(const Scene& scene, const Plan& plan, const PackedScene& packed)
{
    std::string text;
    if (plan.has("picture"))
        text += picturesText(plan, packed);
    text +=
        plan.has("geometry table") ? includeText(sceneTableFile) : lookupText(typicalOf(scene), packed, plan);
    if (plan.view == DataView::trust)
        text += ownKernelText(packed, plan);
    if (plan.form == SceneForm::loop && plan.has("objects"))
        return text + (plan.choosesKernels() ? literalApart(scene, packed, plan) : "") +
               includeText(sceneLoopFile);
    return text + literalScene(scene, packed, plan);
}

} // namespace

SourceText assembled(const Plan& plan, const PackedScene& packed, const SourceText& body,
                     const PreprocessInput& input)
{
    SourceText source = linesOf(countsText(plan, packed), "generated");
    source.insert(source.end(), body.begin(), body.end());
    SourceText result = linesOf("#version 330 core", "generated");
    const SourceText pruned = prune(preprocess(source, input));
    result.insert(result.end(), pruned.begin(), pruned.end());
    return result;
}

SourceText assemble(const Scene& scene, const Plan& plan, const PackedScene& packed,
                    const std::filesystem::path& glslFolder)
{
    const auto main = glslFolder / "ray_trace.frag";
    PreprocessInput input;
    input.search.folders = {glslFolder};
    input.features = plan.defines;
    const auto generate = [&](const char* name, const std::string& text) {
        input.generated[name] = linesOf(text, "generated");
    };
    generate("generated/receive.glsl", receiveText(plan.shared));
    generate("generated/scene.glsl", sceneText(scene, plan, packed));
    generate("generated/lights.glsl", lightsText(packed, plan));
    generate("generated/tree.glsl",
             showsFirstHit(plan.view) ? firstHitText(plan, packed) : treeText(plan.tree));
    return assembled(plan, packed, readSource(main), input);
}

SourceText assembleVertex(const Plan& plan, const PackedScene& packed,
                          const std::filesystem::path& glslFolder)
{
    const auto& values = plan.shared;
    PreprocessInput input;
    input.search.folders = {glslFolder};
    std::string text;
    if (values.empty()) {
        text = fullScreenMain();
    } else {
        for (const char* file : vertexFiles)
            text += includeText(file);
        text += shareDeclaration(values) + "\n" + fullScreenMain(shareStatements(values));
    }
    return assembled(plan, packed, linesOf(text, "generated"), input);
}

std::vector<std::string> includesOfGenerated()
{
    std::vector<std::string> files{firstHitFile, sceneTableFile, sceneLoopFile};
    files.insert(files.end(), vertexFiles.begin(), vertexFiles.end());
    for (const RayTree tree : {RayTree::single, RayTree::chain, RayTree::heaviestFirst, RayTree::breadthFirst,
                               RayTree::depthFirst})
        files.emplace_back(treeFile(tree));
    return files;
}

} // namespace dioptre
