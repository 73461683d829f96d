#include "render/assemble.h"

#include "base/file.h"
#include "base/text.h"
#include "render/preprocess.h"
#include "render/prune.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

// The sizes of the tables, as macros.
std::string countsText(const PackedScene& packed)
{
    return fmt::format("#define MATERIAL_COUNT {}\n#define LIGHT_COUNT {}\n#define SHAPE_COUNT {}\n"
                       "#define POOL_SLOTS {}\n#define QUEUE_SLOTS {}\n\n",
                       std::max<std::size_t>(1, packed.materials.size()), packed.lights.size(),
                       std::max<std::size_t>(1, packed.objects.size()), packed.poolSlots, packed.budget);
}

// "colour = …" from one array; the layer is chosen by selects on the picture's index.
std::string fetchText(const PictureGroup& group)
{
    std::string layer = literal(0.0);
    for (std::size_t i = 1; i < group.pictures.size(); ++i)
        layer =
            fmt::format("picture == {} ? {} : {}", group.pictures[i], literal(static_cast<double>(i)), layer);
    return fmt::format(
        "        vec2 size = vec2({}, {});\n"
        "        float level = pictureLevel(footprint, size);\n"
        "        float layer = {};\n"
        "        colour = textureLod({}, vec3(withinPicture(uv, wraps, level, size), layer), level).xyz;\n",
        literal(group.width), literal(group.height), layer, group.uniform);
}

// pictureColour(): which array and layer a picture's index means.
std::string picturesText(const std::vector<PictureGroup>& groups)
{
    std::string text;
    for (const auto& group : groups)
        text += fmt::format("uniform sampler2DArray {}; // {} x {} texels\n", group.uniform, group.width,
                            group.height);
    text += "\n// Linear colour of a picture; `footprint` is a sample's size as a share of it.\n"
            "vec3 pictureColour(int picture, vec2 uv, vec2 wraps, vec2 footprint)\n{\n"
            "    vec3 colour = vec3(1.0);\n";
    for (const auto& group : groups) {
        std::vector<std::string> tests;
        for (const auto picture : group.pictures)
            tests.push_back(fmt::format("picture == {}", picture));
        text += fmt::format("    if ({}) {{\n{}    }}\n", join(tests, " || "), fetchText(group));
    }
    return text + "    return colour;\n}\n\n";
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
    }
    return "";
}

const char* treeFile(RayTree tree)
{
    switch (tree) {
    case RayTree::single:
        return "single";
    case RayTree::chain:
        return "chain";
    case RayTree::heaviestFirst:
        return "heaviest_first";
    case RayTree::breadthFirst:
        return "breadth_first";
    }
    return "";
}

std::string treeText(RayTree tree)
{
    return fmt::format(
        "#include \"trace/{}.glsl\"\n\n// The ray tree of this scene.\nvec4 traceTree(Path eye)\n{{\n"
        "    return trace{}(eye);\n}}\n\n",
        treeFile(tree), treeFunction(tree));
}

std::string sceneText(const Scene& scene, const Plan& plan, const PackedScene& packed)
{
    std::string text;
    if (plan.has("picture"))
        text += picturesText(pictureGroups(packed));
    if (plan.form == SceneForm::loop && plan.has("objects"))
        return text + "#include \"trace/scene_loop.glsl\"\n";
    return text + literalScene(scene, packed, plan);
}

} // namespace

std::vector<PictureGroup> pictureGroups(const PackedScene& packed)
{
    std::vector<PictureGroup> groups;
    for (std::size_t i = 0; i < packed.pictures.size(); ++i) {
        const auto& picture = packed.pictures[i].front();
        auto group = std::find_if(groups.begin(), groups.end(), [&](const PictureGroup& g) {
            return g.width == picture.width && g.height == picture.height && g.format == picture.format;
        });
        if (group == groups.end()) {
            groups.push_back({picture.width,
                              picture.height,
                              picture.format,
                              {},
                              fmt::format("u_pictures{}", groups.size())});
            group = groups.end() - 1;
        }
        group->pictures.push_back(i);
    }
    return groups;
}

SourceText assemble(const Scene& scene, const Plan& plan, const PackedScene& packed,
                    const std::filesystem::path& glslFolder)
{
    const auto main = glslFolder / "ray_trace.frag";
    PreprocessInput input;
    input.folder = glslFolder;
    input.features = plan.defines;
    input.generated["generated/scene.glsl"] = linesOf(sceneText(scene, plan, packed), "generated");
    input.generated["generated/tree.glsl"] = linesOf(treeText(plan.tree), "generated");
    SourceText source = linesOf(countsText(packed), "generated");
    const SourceText body = linesOf(readFile(main), main.string());
    source.insert(source.end(), body.begin(), body.end());
    SourceText result = linesOf("#version 330 core", "generated");
    const SourceText pruned = prune(preprocess(source, input));
    result.insert(result.end(), pruned.begin(), pruned.end());
    return result;
}

} // namespace dioptre
