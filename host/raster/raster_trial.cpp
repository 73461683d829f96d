#include "raster/raster_trial.h"

#include "raster/mesh_buffer.h"
#include "raster/object_buffer.h"
#include "raster/shadow_pass.h"
#include "render/device_scene.h"

namespace dioptre
{
namespace
{

// A net of few facets, its corners one after the other.
std::vector<float> cornersOf(int kind)
{
    const Mesh mesh = meshOf(kind, leastFacets, true);
    const std::vector<float> vertices = floatsOf(mesh, true);
    const auto each = static_cast<std::ptrdiff_t>(vertices.size() / mesh.vertices.size());
    std::vector<float> corners;
    for (const std::uint32_t index : mesh.indices) {
        const auto first = vertices.begin() + each * static_cast<std::ptrdiff_t>(index);
        corners.insert(corners.end(), first, first + each);
    }
    return corners;
}

TextureShape floatTexture(GLenum target, GLenum stored)
{
    TextureShape shape;
    shape.target = target;
    shape.stored = stored;
    shape.numberType = GL_FLOAT;
    shape.minification = GL_NEAREST;
    shape.magnification = GL_NEAREST;
    return shape;
}

} // namespace

ProgramTrial trialOf(const RasterScene& raster, const RasterText& text)
{
    const auto& packed = raster.prepared.packed;
    ProgramTrial trial{flatten(text.fragment), flatten(text.vertex), {}, {}, {}};
    for (const auto& name : text.fed)
        if (name.ends_with("Block"))
            trial.blocks[name] = name == "ShadowBlock"   ? numbersOf(raster.shadows)
                                 : name == "ObjectBlock" ? numbersOfObject(packed, raster.shadows.planeOf, 0)
                                                         : blockValues(name, packed);
    trial.uniforms = fixedUniforms(packed, trialSize_px, {0, 0});
    trial.uniforms["u_side"] = {1.0};
    const auto& absorption = raster.eyeAbsorption;
    trial.uniforms["u_eye_absorption"] = {absorption.x, absorption.y, absorption.z};
    trial.uniforms["u_near_m"] = {raster.near_m};
    trial.uniforms["u_shadow_bias"] = {raster.prepared.scene.raster.shadowBias};
    trial.textures = textureShapes(raster.prepared.plan, packed);
    trial.textures.emplace_back("u_shadow_maps", floatTexture(GL_TEXTURE_2D_ARRAY, GL_R32F));
    trial.textures.emplace_back("u_sample", floatTexture(GL_TEXTURE_2D, GL_RGBA32F));
    if (!text.vertex.empty())
        trial.corners = cornersOf(packed.objects.front().kind);
    return trial;
}

} // namespace dioptre
