// From a plan to the one shader that draws the scene.
#pragma once

#include "render/literal.h"
#include "render/picture_groups.h"
#include "render/preprocess.h"
#include "render/source_text.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

// glsl/ray_trace.frag with its includes, the plan's features and the generated scene; nothing that main()
// does not reach. The text begins with #version and is deterministic. Throws badInput or inputMissing for
// faults in glsl/.
SourceText assemble(const Scene& scene, const Plan& plan, const PackedScene& packed,
                    const std::filesystem::path& glslFolder);

// The vertex shader that goes with it: the full-screen triangle, and what all its pixels share.
SourceText assembleVertex(const Plan& plan, const PackedScene& packed,
                          const std::filesystem::path& glslFolder);

// The version, the tables' sizes and `body` with its includes, less what main() does not reach.
SourceText assembled(const Plan& plan, const PackedScene& packed, const SourceText& body,
                     const PreprocessInput& input);

// Includes whose names begin so are written by assemble() itself.
inline constexpr std::string_view generatedFolder = "generated/";

// Every file of glsl/ that what assemble() writes may include, whatever the scene.
std::vector<std::string> includesOfGenerated();

} // namespace dioptre
