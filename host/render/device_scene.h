// A packed scene on the device: buffers, textures, and the table of what the program must ask for.
#pragma once

#include "gl/object.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/assemble.h"

#include <glm/glm.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dioptre
{

// A texture and the sampler uniform that reads it.
struct BoundTexture {
    std::string uniform;
    Texture texture;
    GLenum target = GL_TEXTURE_2D;
    std::vector<std::size_t> pictures; // indices into PackedScene::pictures, by layer; none of the sky
};

// A buffer and the uniform block that reads it.
struct BoundBlock {
    std::string block;
    Buffer buffer;
    std::size_t bytes = 0;
};

struct DeviceScene {
    std::vector<BoundBlock> blocks;
    std::vector<BoundTexture> textures;
    std::size_t textureBytes = 0;
};

// How many of a scene's parts fit in uniform blocks of a size.
struct BlockCapacity {
    std::size_t materials = 0;
    std::size_t lights = 0;
    std::size_t tableObjects = 0; // under trace.form = "loop"
};
BlockCapacity capacityOf(std::size_t blockBytes);

// The numbers of a uniform block, as the device holds them.
std::vector<float> blockValues(const std::string& block, const PackedScene& packed);

// The uniforms outside blocks that stay the same between draws, by name, and the textures by their samplers'
// names.
std::map<std::string, std::vector<double>> fixedUniforms(const PackedScene& packed, const glm::ivec2& size_px,
                                                         const glm::ivec2& origin_px);
std::vector<std::pair<std::string, TextureShape>> textureShapes(const Plan& plan, const PackedScene& packed);

// Uploads what one of the plans, which are of one scene, needs, and nothing else.
// `kept`: textures of the very same pictures, of which those that hold what is wanted are taken over.
DeviceScene upload(const PackedScene& packed, const std::vector<const Plan*>& plans,
                   std::vector<BoundTexture> kept = {});

// Uploads the numbers anew, of the same scene at another time; the pictures stay.
void uploadNumbers(DeviceScene& device, const PackedScene& packed);

// What a plan's program reads: uniforms outside blocks, blocks, and textures.
std::vector<std::string> plannedUniforms(const Plan& plan);
std::vector<std::string> plannedBlocks(const Plan& plan);
std::vector<std::string> plannedTextures(const Plan& plan, const PackedScene& packed);

// Compares the program's active uniforms and blocks with the plan's, both ways: a difference is a fault in
// dioptre or in an edited shader. Throws badInput naming each.
void checkInterface(const Program& program, const PackedScene& packed, const Plan& plan);

// The same with the names of all uniforms outside blocks and of all blocks that are fed.
void checkInterface(const Program& program, const std::vector<std::string>& fed);

// Where an active uniform is; -1, which OpenGL ignores, where the scene does not need it.
GLint locationOf(const Program& program, const std::string& name);

// Makes the program current, binds those buffers and textures that it reads, and sets every uniform that
// stays the same between draws. `origin_px`: the lower left corner of what is drawn, in the whole picture.
void bind(const Program& program, const DeviceScene& device, const PackedScene& packed,
          const glm::ivec2& size_px, const glm::ivec2& origin_px);

} // namespace dioptre
