// From a plan to the one shader that draws the scene.
#pragma once

#include "render/literal.h"
#include "render/source_text.h"

#include <filesystem>

namespace dioptre
{

// The pictures of one size and format share an array texture; a picture is a layer of its group.
struct PictureGroup {
    int width = 0;
    int height = 0;
    PixelFormat format = PixelFormat::srgb8;
    std::vector<std::size_t> pictures; // indices into PackedScene::pictures, by layer
    std::string uniform;               // "u_pictures0"
};

std::vector<PictureGroup> pictureGroups(const PackedScene& packed);

// glsl/ray_trace.frag with its includes, the plan's features and the generated scene; nothing that main()
// does not reach. The text begins with #version and is deterministic. Throws badInput or inputMissing for
// faults in glsl/.
SourceText assemble(const Scene& scene, const Plan& plan, const PackedScene& packed,
                    const std::filesystem::path& glslFolder);

// The vertex shader that goes with it: the full-screen triangle, and what all its pixels share.
SourceText assembleVertex(const Plan& plan, const PackedScene& packed,
                          const std::filesystem::path& glslFolder);

} // namespace dioptre
