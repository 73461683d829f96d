#include "render/device_scene.h"

#include "base/text.h"

#include <algorithm>
#include <array>
#include <functional>

namespace dioptre
{
namespace
{

// Appends a struct of dvec4 as floats, member by member.
template <typename Struct>
void append(std::vector<float>& values, const Struct& packed)
{
    static_assert(sizeof(Struct) % sizeof(packed::vec4) == 0);
    const auto* numbers = reinterpret_cast<const double*>(&packed);
    std::transform(numbers, numbers + sizeof(Struct) / sizeof(double), std::back_inserter(values),
                   [](double number) { return static_cast<float>(number); });
}

template <typename Range>
void appendAll(std::vector<float>& values, const Range& range)
{
    for (const auto& item : range)
        append(values, item);
}

std::size_t bytesOf(const std::vector<Picture>& levels)
{
    std::size_t bytes = 0;
    for (const auto& level : levels)
        bytes += level.bytes.size() + level.floats.size() * sizeof(float);
    return bytes;
}

bool holds(const std::vector<std::string>& names, const std::string& name)
{
    return std::ranges::find(names, name) != names.end();
}

// The names that one of the plans gives, each once.
template <typename Names>
std::vector<std::string> namesOfAll(const std::vector<const Plan*>& plans, Names namesOf)
{
    std::vector<std::string> all;
    for (const Plan* plan : plans)
        for (const auto& name : namesOf(*plan))
            if (!holds(all, name))
                all.push_back(name);
    return all;
}

// The mip chains of a group's pictures, by layer.
std::vector<std::span<const Picture>> layersOf(const PictureGroup& group, const PackedScene& packed)
{
    std::vector<std::span<const Picture>> layers;
    for (const auto picture : group.pictures)
        layers.push_back(packed.pictures[picture]);
    return layers;
}

// Of those that are kept the one that holds this, or what `make` makes.
BoundTexture keptOr(std::vector<BoundTexture>& kept, const std::string& uniform,
                    const std::vector<std::size_t>& pictures, GLenum target,
                    const std::function<Texture()>& make)
{
    for (auto& texture : kept)
        if (texture.uniform == uniform && texture.pictures == pictures && texture.target == target)
            return std::move(texture);
    return {uniform, make(), target, pictures};
}

void uploadTextures(DeviceScene& device, const std::vector<const Plan*>& plans, const PackedScene& packed,
                    std::vector<BoundTexture> kept)
{
    const auto wanted = namesOfAll(plans, [&](const Plan& plan) { return plannedTextures(plan, packed); });
    for (const auto& group : pictureGroups(*plans.front(), packed)) {
        if (!holds(wanted, group.uniform))
            continue;
        for (const auto picture : group.pictures)
            device.textureBytes += bytesOf(packed.pictures[picture]);
        device.textures.push_back(keptOr(kept, group.uniform, group.pictures, GL_TEXTURE_2D_ARRAY,
                                         [&] { return uploadPictureArray(layersOf(group, packed)); }));
    }
    if (holds(wanted, "u_sky_picture")) {
        device.textures.push_back(keptOr(kept, "u_sky_picture", {}, GL_TEXTURE_2D,
                                         [&] { return uploadSky(packed.sky_picture.front()); }));
        device.textureBytes += bytesOf(packed.sky_picture);
    }
}

// A struct of every object that moves.
template <typename Struct>
std::vector<float> movingValues(const PackedScene& packed, Struct PackedObject::*of)
{
    std::vector<float> values;
    for (const auto& object : packed.objects) // slots rise with the ids
        if (object.moving >= 0)
            append(values, object.*of);
    return values;
}

std::vector<float> shapeValues(const PackedScene& packed)
{
    const ShapeTable table = shapeTable(packed);
    std::vector<float> values;
    appendAll(values, table.shapes);
    appendAll(values, table.index);
    appendAll(values, table.kindFirst);
    return values;
}

struct BlockContents {
    std::vector<float> values;
    const char* what; // to have fewer of, where it is too much
};

BlockContents contentsOf(const std::string& block, const PackedScene& packed)
{
    const auto structs = [](const auto& range, const char* what) {
        BlockContents contents{{}, what};
        appendAll(contents.values, range);
        return contents;
    };
    if (block == "CameraBlock")
        return structs(std::array{packed.camera}, "cameras");
    if (block == "SkyBlock")
        return structs(std::array{packed.sky}, "skies");
    if (block == "MaterialBlock")
        return structs(packed.materials, "materials");
    if (block == "LightBlock")
        return structs(packed.lights, "lights");
    if (block == "ShapeBlock")
        return {shapeValues(packed), "objects, which this shader reads from a table,"};
    if (block == "FineBlock")
        return {movingValues(packed, &PackedObject::fine), "objects that move"};
    return {movingValues(packed, &PackedObject::shape), "objects that move"};
}

// Throws badInput where the driver's blocks are smaller.
BoundBlock blockOf(const std::string& name, const PackedScene& packed)
{
    const auto [values, contents] = contentsOf(name, packed);
    GLint most = 0;
    glGetIntegerv(GL_MAX_UNIFORM_BLOCK_SIZE, &most);
    const std::size_t bytes = values.size() * sizeof(float);
    if (bytes > static_cast<std::size_t>(most))
        fail(ExitCode::badInput,
             std::string("the scene's ") + contents + " take " + std::to_string(bytes) +
                 " bytes, and this driver's uniform blocks hold " + std::to_string(most),
             std::string("use fewer ") + contents);
    return {name, uploadUniformBuffer(values), bytes};
}

// "a, b" of what is in `wanted` and not in `present`.
std::string missing(const std::vector<std::string>& wanted, const std::vector<std::string>& present)
{
    std::vector<std::string> names;
    for (const auto& name : wanted)
        if (!holds(present, name))
            names.push_back(name);
    return join(names, ", ");
}

} // namespace

BlockCapacity capacityOf(std::size_t blockBytes)
{
    // The structs hold doubles here and floats on the device.
    const auto bytes = [](std::size_t hostBytes) { return hostBytes * sizeof(float) / sizeof(double); };
    const std::size_t head = bytes(sizeof(ShapeTable::kindFirst));
    const std::size_t tableRoom = blockBytes > head ? blockBytes - head : 0;
    return {blockBytes / bytes(sizeof(packed::Material)), blockBytes / bytes(sizeof(packed::Light)),
            tableRoom / bytes(sizeof(packed::Shape) + sizeof(packed::vec4))};
}

std::vector<float> blockValues(const std::string& block, const PackedScene& packed)
{
    return contentsOf(block, packed).values;
}

std::vector<std::pair<std::string, TextureShape>> textureShapes(const Plan& plan, const PackedScene& packed)
{
    std::vector<std::pair<std::string, TextureShape>> shapes;
    if (plan.has("picture"))
        for (const auto& group : sampledGroups(plan, packed))
            shapes.emplace_back(group.uniform, shapeOfPictureArray(layersOf(group, packed)));
    if (plan.has("sky picture"))
        shapes.emplace_back("u_sky_picture", shapeOfSky(packed.sky_picture.front()));
    return shapes;
}

DeviceScene upload(const PackedScene& packed, const std::vector<const Plan*>& plans,
                   std::vector<BoundTexture> kept)
{
    DeviceScene device;
    for (const auto& name : namesOfAll(plans, plannedBlocks))
        device.blocks.push_back(blockOf(name, packed));
    uploadTextures(device, plans, packed, std::move(kept));
    return device;
}

void uploadNumbers(DeviceScene& device, const PackedScene& packed)
{
    for (auto& block : device.blocks)
        block = blockOf(block.block, packed);
}

std::vector<std::string> plannedBlocks(const Plan& plan)
{
    std::vector<std::string> names = {"CameraBlock"};
    if (!showsFirstHit(plan.view))
        names.emplace_back("SkyBlock");
    if (plan.readsMaterials)
        names.emplace_back("MaterialBlock");
    if (!plan.placedLights.empty() || !plan.glowing.empty())
        names.emplace_back("LightBlock");
    if (plan.has("geometry table"))
        names.emplace_back("ShapeBlock");
    if (plan.has("moving geometry"))
        names.emplace_back("MovingBlock");
    if (plan.readsFine)
        names.emplace_back("FineBlock");
    return names;
}

std::vector<std::string> plannedTextures(const Plan& plan, const PackedScene& packed)
{
    std::vector<std::string> names;
    if (plan.has("picture"))
        for (const auto& group : sampledGroups(plan, packed))
            names.push_back(group.uniform);
    if (plan.has("sky picture"))
        names.emplace_back("u_sky_picture");
    return names;
}

std::vector<std::string> plannedUniforms(const Plan& plan)
{
    std::vector<std::string> names = {"u_sample_count"};
    if (seesDirections(plan))
        names.insert(names.end(), {"u_resolution", "u_tile_origin_px", "u_sample_first"});
    if (plan.tree != RayTree::single) {
        names.emplace_back("u_budget");
        names.emplace_back("u_cut_off");
    }
    if (plan.has("depth limit"))
        names.emplace_back("u_depth");
    if (plan.has("ambient light"))
        names.emplace_back("u_ambient");
    if (plan.choosesKernels() && plan.guard == Guard::unit)
        names.emplace_back("u_one");
    return names;
}

void checkInterface(const Program& program, const PackedScene& packed, const Plan& plan)
{
    // One list for all: their names never meet.
    auto names = plannedUniforms(plan);
    for (const auto& name : plannedTextures(plan, packed))
        names.push_back(name);
    for (const auto& name : plannedBlocks(plan))
        names.push_back(name);
    checkInterface(program, names);
}

void checkInterface(const Program& program, const std::vector<std::string>& fed)
{
    auto activeUniforms = keysOf(program.uniforms);
    const auto activeBlocks = keysOf(program.uniformBlocks);
    activeUniforms.insert(activeUniforms.end(), activeBlocks.begin(), activeBlocks.end());
    const std::string unread = missing(fed, activeUniforms);
    const std::string unfed = missing(activeUniforms, fed);
    if (!unread.empty())
        fail(
            ExitCode::badInput, "the plan feeds " + unread + ", and the shader does not read it",
            "undo the edit in glsl/; if there was none, this is a fault of dioptre: please report the scene");
    if (!unfed.empty())
        fail(
            ExitCode::badInput, "the shader reads " + unfed + ", and nothing feeds it",
            "undo the edit in glsl/; if there was none, this is a fault of dioptre: please report the scene");
}

GLint locationOf(const Program& program, const std::string& name)
{
    const auto found = program.uniforms.find(name);
    return found == program.uniforms.end() ? -1 : found->second;
}

void bind(const Program& program, const DeviceScene& device, const PackedScene& packed,
          const glm::ivec2& size_px, const glm::ivec2& origin_px)
{
    glUseProgram(program.name.name());
    GLuint binding = 0;
    for (const auto& block : device.blocks) {
        const auto index = program.uniformBlocks.find(block.block);
        if (index == program.uniformBlocks.end())
            continue;
        glUniformBlockBinding(program.name.name(), index->second, binding);
        glBindBufferBase(GL_UNIFORM_BUFFER, binding++, block.buffer.name());
    }
    GLint unit = 0;
    for (const auto& texture : device.textures) {
        if (locationOf(program, texture.uniform) < 0)
            continue;
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(texture.target, texture.texture.name());
        glUniform1i(locationOf(program, texture.uniform), unit++);
    }
    for (const auto& [name, numbers] : fixedUniforms(packed, size_px, origin_px)) {
        const GLint location = locationOf(program, name);
        const auto number = [&numbers = numbers](std::size_t i) { return static_cast<GLfloat>(numbers[i]); };
        if (name == "u_budget" || name == "u_depth")
            glUniform1i(location, static_cast<GLint>(numbers[0]));
        else if (numbers.size() == 3)
            glUniform3f(location, number(0), number(1), number(2));
        else if (numbers.size() == 2)
            glUniform2f(location, number(0), number(1));
        else
            glUniform1f(location, number(0));
    }
}

std::map<std::string, std::vector<double>> fixedUniforms(const PackedScene& packed, const glm::ivec2& size_px,
                                                         const glm::ivec2& origin_px)
{
    const auto pair = [](const glm::dvec2& numbers) { return std::vector<double>{numbers.x, numbers.y}; };
    return {{"u_resolution", pair(size_px)},
            {"u_tile_origin_px", pair(origin_px)},
            {"u_budget", {static_cast<double>(packed.budget)}},
            {"u_cut_off", {packed.cutOff}},
            {"u_depth", {static_cast<double>(packed.depth)}},
            {"u_one", {1.0}},
            {"u_ambient", {packed.ambient.x, packed.ambient.y, packed.ambient.z}}};
}

} // namespace dioptre
