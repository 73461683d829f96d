#include "raster/raster_renderer.h"

#include "base/clock.h"
#include "base/text.h"
#include "raster/frustum.h"
#include "raster/raster_plan.h"
#include "render/build.h"
#include "render/still.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

#include "../glsl/raster/cell.glsl"

// Those of the picture that meet the area, whole.
std::vector<PixelRectangle> cellsOf(const PixelRectangle& area, const PixelRectangle& picture)
{
    std::vector<PixelRectangle> cells;
    for (int y = area.y / CELL_PX * CELL_PX; y < area.y + area.height; y += CELL_PX)
        for (int x = area.x / CELL_PX * CELL_PX; x < area.x + area.width; x += CELL_PX)
            cells.push_back(common({x, y, CELL_PX, CELL_PX}, picture));
    return cells;
}

Program buildProgram(const RasterText& text)
{
    Program program =
        text.vertex.empty() ? buildProgram(text.fragment) : buildProgram(text.fragment, text.vertex);
    checkInterface(program, text.fed);
    return program;
}

// Light that is handed on from facets or vertices takes a place for each light.
void refuseCrowdedStage(const Plan& plan, const Method& method)
{
    const auto has = [&](const char* define) { return plan.defines.contains(define); };
    if (!has("HAS_LIT_FACETS") && !has("HAS_LIT_VERTICES"))
        return;
    const int each = has("HAS_HIGHLIGHT") ? 2 : 1;
    GLint outputs = 0;
    GLint inputs = 0;
    glGetIntegerv(GL_MAX_VERTEX_OUTPUT_COMPONENTS, &outputs);
    glGetIntegerv(GL_MAX_FRAGMENT_INPUT_COMPONENTS, &inputs);
    const int most = (std::min(outputs, inputs) / 4 - 5) / each; // place, normals, ambient, position
    if (litParts(plan) > most)
        fail(ExitCode::badInput,
             fmt::format("{} lights with shadows are more than {} can hand from corners to pixels here: {} "
                         "are the most",
                         litParts(plan), nameOf(method), most),
             "draw by --method phong, or without shadow maps by --set raster.shadow_map=0");
}

} // namespace

RasterRenderer::RasterRenderer(const RasterScene& raster, const ViewSettings& view)
    : RasterRenderer(raster, view, rasterTexts(raster, view.glslFolder))
{
}

RasterRenderer::RasterRenderer(const RasterScene& raster, const ViewSettings& view, RasterTexts texts)
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), raster_(&raster), view_(view),
      texts_(std::move(texts))
{
    Stopwatch watch;
    refuseCrowdedStage(raster.prepared.plan, raster.method);
    dealSamples();
    device_ = upload(raster.prepared.packed, {&raster.prepared.plan});
    std::vector<int> kinds;
    for (const auto& object : raster.prepared.packed.objects)
        kinds.push_back(object.kind);
    meshes_ = uploadMeshes(kinds, raster.method);
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    noVertices_ = VertexArray(name);
    times_.load = watch.lap_ms();
    build();
    placeObjects();
    times_.compile = watch.lap_ms();
    const PixelRectangle first{0, 0, 1, 1};
    drawSample(cellsOf(first, {0, 0, view.width, view.height}).front(), 0, first);
    waitForFirst();
    times_.firstDraw = watch.lap_ms();
}

void RasterRenderer::build()
{
    if (!texts_.surface.fragment.empty())
        surface_ = buildProgram(texts_.surface);
    if (!texts_.caster.fragment.empty())
        shadows_ = ShadowPass(*raster_, texts_.caster);
    sky_ = buildProgram(texts_.sky);
    add_ = buildProgram(texts_.add);
}

void RasterRenderer::placeObjects()
{
    objectNumbers_ = uploadObjects(raster_->prepared.packed, raster_->shadows.planeOf);
    shadows_.update(*raster_, device_);
    seen_ = seenBy(raster_->prepared.packed, view_.width, view_.height, hasEndlessPlanes(raster_->method));
}

void RasterRenderer::update(const RasterScene& raster)
{
    update(raster, view_);
}

void RasterRenderer::update(const RasterScene& raster, const ViewSettings& view)
{
    raster_ = &raster;
    view_ = view;
    resize(targetWidth(view), targetHeight(view));
    dealSamples();
    shadows_.release(device_);
    uploadNumbers(device_, raster.prepared.packed);
    placeObjects();
}

void RasterRenderer::updatePictures(const RasterScene& raster)
{
    raster_ = &raster;
    device_ = {}; // the device need not hold both
    device_ = upload(raster.prepared.packed, {&raster.prepared.plan});
    placeObjects();
}

void RasterRenderer::showWires(bool on)
{
    wires_ = on;
    if (on && !wire_ && surface_)
        wire_ = buildProgram(texts_.wire);
}

void RasterRenderer::use(const Program& program, const PixelRectangle& cell, int sample) const
{
    bind(program, device_, raster_->prepared.packed, {view_.width, view_.height}, {cell.x, cell.y});
    glUniform1i(locationOf(program, "u_sample_first"), sample);
    glUniform1f(locationOf(program, "u_near_m"), static_cast<GLfloat>(raster_->near_m));
    const glm::vec3 absorption(raster_->eyeAbsorption);
    glUniform3f(locationOf(program, "u_eye_absorption"), absorption.x, absorption.y, absorption.z);
    attachObjects(program);
    shadows_.bindTo(program, *raster_, device_);
}

// Every object in the order of their ids, so that of two at one depth the first stays. No side is drawn that
// cannot be seen.
void RasterRenderer::drawObjects(const Program& program) const
{
    const auto& objects = raster_->prepared.packed.objects;
    const glm::dvec3 eye(raster_->prepared.packed.camera.eye);
    glEnable(GL_CULL_FACE);
    for (std::size_t id = 0; id < objects.size(); ++id) {
        if (!seen_[id])
            continue;
        const MeshBuffer& mesh = meshes_.at(objects[id].kind);
        showObject(objectNumbers_, id);
        const auto drawSide = [&](GLenum culled, GLfloat side) {
            glCullFace(culled);
            glUniform1f(locationOf(program, "u_side"), side);
            dioptre::draw(mesh);
        };
        const SeenSides sides = sidesSeenFrom(objects[id], eye);
        if (sides.outer)
            drawSide(GL_BACK, 1.0F);
        if (sides.inner)
            drawSide(GL_FRONT, -1.0F);
    }
    glDisable(GL_CULL_FACE);
}

// Behind all that was drawn: at the depth that was cleared to.
void RasterRenderer::drawSky(const PixelRectangle& cell, int sample)
{
    glDepthRange(0.0, 0.0);
    glDepthFunc(GL_GEQUAL);
    glViewport(0, 0, sample_->width, sample_->height);
    use(sky_, cell, sample);
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRange(0.0, 1.0);
}

void RasterRenderer::drawWires(const PixelRectangle& cell, int sample)
{
    if (!wires_ || !wire_)
        return;
    glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
    use(*wire_, cell, sample);
    drawObjects(*wire_);
    glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
}

// One sample of what of the cell lies in the area, into the lower left of the sample's target.
void RasterRenderer::drawSample(const PixelRectangle& cell, int sample, const PixelRectangle& area)
{
    const PixelRectangle wanted = common(cell, area);
    const int width = wanted.x + wanted.width - cell.x;
    const int height = wanted.y + wanted.height - cell.y;
    if (!sample_ || sample_->width < width || sample_->height < height)
        sample_ = makeSampleTarget(std::max(width, sample_ ? sample_->width : 0),
                                   std::max(height, sample_ ? sample_->height : 0));
    shadows_.draw(*raster_, device_, objectNumbers_, meshes_);
    glBindFramebuffer(GL_FRAMEBUFFER, sample_->framebuffer.name());
    glEnable(GL_SCISSOR_TEST);
    glScissor(wanted.x - cell.x, wanted.y - cell.y, wanted.width, wanted.height);
    const GLfloat farthest = 0.0F;           // see glsl/raster/nearness.glsl
    glClearBufferfv(GL_DEPTH, 0, &farthest); // the sky covers every other pixel
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_GREATER);
    glViewport(0, 0, cell.width, cell.height);
    if (surface_) {
        use(*surface_, cell, sample);
        drawObjects(*surface_);
        drawWires(cell, sample);
    }
    drawSky(cell, sample);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

// One at a time: a sample is a picture of its own.
void RasterRenderer::dealSamples()
{
    batches_.clear();
    for (int i = 0; i < view_.samples; ++i)
        batches_.push_back({i, 1});
}

void RasterRenderer::drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area)
{
    const PixelRectangle shown = common(area, region_);
    for (const PixelRectangle& cell : cellsOf(shown, {0, 0, view_.width, view_.height}))
        for (const auto& batch : batches)
            for (int sample = batch.first; sample < batch.first + batch.count; ++sample) {
                drawSample(cell, sample, shown);
                glUseProgram(add_.name.name());
                glActiveTexture(GL_TEXTURE0);
                glBindTexture(GL_TEXTURE_2D, sample_->colour.name());
                glUniform1i(locationOf(add_, "u_sample"), 0);
                glUniform2i(locationOf(add_, "u_sample_origin_px"), region_.x - cell.x, region_.y - cell.y);
                cover(common(cell, shown));
            }
}

std::span<const SampleBatch> RasterRenderer::batches() const
{
    return batches_;
}

PixelCounts RasterRenderer::finish(Picture& picture) const
{
    return meansOfSums(picture, view_.samples);
}

RasterFacts RasterRenderer::rasterFacts() const
{
    RasterFacts facts;
    for (std::size_t id = 0; id < seen_.size(); ++id) {
        facts.drawn += seen_[id] ? 1 : 0;
        facts.culled += seen_[id] ? 0 : 1;
        facts.triangles += seen_[id] ? meshes_.at(raster_->prepared.packed.objects[id].kind).count / 3 : 0;
    }
    if (const ShadowMaps* maps = shadows_.maps()) {
        facts.shadowMaps = maps->layers;
        facts.shadowMap_px = maps->side;
        facts.shadowMapDraws = shadows_.draws();
    }
    return facts;
}

DrawingFacts RasterRenderer::facts() const
{
    DrawingFacts facts;
    facts.shader = texts_.surface.fragment.empty() ? texts_.sky.fragment : texts_.surface.fragment;
    facts.vertexShader = texts_.surface.vertex;
    const Program& program = surface_ ? *surface_ : sky_;
    facts.uniforms = keysOf(program.uniforms);
    facts.blocks = keysOf(program.uniformBlocks);
    facts.textureBytes = device_.textureBytes;
    for (const auto& texture : device_.textures)
        facts.textures.push_back(texture.uniform);
    if (const ShadowMaps* maps = shadows_.maps()) {
        facts.textures.emplace_back("u_shadow_maps");
        facts.textureBytes += bytesOf(*maps);
    }
    facts.raster = rasterFacts();
    return facts;
}

} // namespace dioptre
