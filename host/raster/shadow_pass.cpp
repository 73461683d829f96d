#include "raster/shadow_pass.h"

#include "render/build.h"

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

constexpr const char* blockName = "ShadowBlock";

template <typename Struct>
void append(std::vector<float>& values, const std::vector<Struct>& structs)
{
    const auto* numbers = reinterpret_cast<const double*>(structs.data());
    std::transform(numbers, numbers + structs.size() * sizeof(Struct) / sizeof(double),
                   std::back_inserter(values), [](double number) { return static_cast<float>(number); });
}

// What stands in the lights' way, and where.
std::vector<float> castersOf(const RasterScene& raster)
{
    std::vector<packed::Shape> shapes;
    std::vector<float> values;
    for (const auto& views : raster.shadows.lights)
        for (std::size_t id = 0; id < views.casts.size(); ++id)
            if (views.casts[id]) {
                values.push_back(static_cast<float>(id));
                shapes.push_back(raster.prepared.packed.objects[id].shape);
            }
    append(values, shapes);
    return values;
}

} // namespace

std::vector<float> numbersOf(const ShadowViews& shadows)
{
    std::vector<float> values;
    append(values, shadows.views);
    append(values, shadows.planes);
    if (shadows.planes.empty())
        values.insert(values.end(), 4, 0.0F); // the block's array has one at least
    return values;
}

ShadowPass::ShadowPass(const RasterScene& raster, const RasterText& text)
    : maps_(makeShadowMaps(raster.prepared.scene.raster.shadowMap_px,
                           static_cast<int>(raster.shadows.views.size()))),
      caster_(buildProgram(text.fragment, text.vertex))
{
    checkInterface(caster_, text.fed);
}

void ShadowPass::update(const RasterScene& raster, DeviceScene& device)
{
    if (!maps_)
        return;
    const std::vector<float> values = numbersOf(raster.shadows);
    std::vector<float> seen = castersOf(raster);
    seen.insert(seen.end(), values.begin(), values.end());
    if (seen != seen_) // an eye that moves moves no shadow
        drawn_ = false;
    seen_ = std::move(seen);
    release(device);
    device.blocks.push_back({blockName, uploadUniformBuffer(values), values.size() * sizeof(float)});
}

void ShadowPass::release(DeviceScene& device)
{
    std::erase_if(device.blocks, [](const BoundBlock& block) { return block.block == blockName; });
}

void ShadowPass::draw(const RasterScene& raster, const DeviceScene& device, const ObjectBuffer& objects,
                      const MeshBuffers& meshes)
{
    if (!maps_ || drawn_)
        return;
    glBindFramebuffer(GL_FRAMEBUFFER, maps_->framebuffer.name());
    glViewport(0, 0, maps_->side, maps_->side);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    const auto& packed = raster.prepared.packed;
    bind(caster_, device, packed, {maps_->side, maps_->side}, {0, 0});
    attachObjects(caster_);
    for (std::size_t light = 0; light < raster.shadows.lights.size(); ++light) {
        const auto& views = raster.shadows.lights[light];
        for (int layer = views.first; layer < views.first + views.count; ++layer)
            drawLayer(layer, views.casts, raster, objects, meshes);
    }
    glDisable(GL_DEPTH_TEST);
    drawn_ = true;
    ++draws_;
}

void ShadowPass::drawLayer(int layer, const std::vector<bool>& casting, const RasterScene& raster,
                           const ObjectBuffer& numbers, const MeshBuffers& meshes) const
{
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, maps_->distances.name(), 0, layer);
    const std::array<GLfloat, 4> farAway{static_cast<GLfloat>(packed::FAR_AWAY), 0.0F, 0.0F, 0.0F};
    const GLfloat deepest = 0.0F; // see glsl/raster/nearness.glsl
    glClearBufferfv(GL_COLOR, 0, farAway.data());
    glClearBufferfv(GL_DEPTH, 0, &deepest);
    glUniform1i(locationOf(caster_, "u_shadow_view"), layer);
    const auto& objects = raster.prepared.packed.objects;
    for (std::size_t id = 0; id < objects.size(); ++id) {
        if (!casting[id])
            continue;
        showObject(numbers, id);
        dioptre::draw(meshes.at(objects[id].kind));
    }
}

void ShadowPass::bindTo(const Program& program, const RasterScene& raster, const DeviceScene& device) const
{
    if (!maps_)
        return;
    glUniform1f(locationOf(program, "u_shadow_bias"),
                static_cast<GLfloat>(raster.prepared.scene.raster.shadowBias));
    const GLint sampler = locationOf(program, "u_shadow_maps");
    if (sampler < 0)
        return;
    const auto unit = static_cast<GLint>(device.textures.size());
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D_ARRAY, maps_->distances.name());
    glUniform1i(sampler, unit);
    glActiveTexture(GL_TEXTURE0);
}

} // namespace dioptre
