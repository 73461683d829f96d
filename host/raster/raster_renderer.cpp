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

// Pictures are rasterised in cells of a fixed grid, so that a tile's pixels are rounded as the whole
// picture's are.
constexpr int cellSide_px = 2048;

// Those that meet the area, whole.
std::vector<PixelRectangle> cellsOf(const PixelRectangle& area)
{
    std::vector<PixelRectangle> cells;
    for (int y = area.y / cellSide_px * cellSide_px; y < area.y + area.height; y += cellSide_px)
        for (int x = area.x / cellSide_px * cellSide_px; x < area.x + area.width; x += cellSide_px)
            cells.push_back({x, y, cellSide_px, cellSide_px});
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
    : Drawing(targetWidth(view), targetHeight(view), view.drawLimit_s), raster_(&raster), view_(view)
{
    Stopwatch watch;
    refuseCrowdedStage(raster.prepared.plan, raster.method);
    texts_ = rasterTexts(raster, view.glslFolder);
    for (int i = 0; i < view.samples; ++i)
        batches_.push_back({i, 1});
    device_ = upload(raster.prepared.packed, {&raster.prepared.plan});
    makeMeshes();
    makeShadows();
    see();
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    noVertices_ = VertexArray(name);
    times_.load = watch.lap_ms();
    build();
    times_.compile = watch.lap_ms();
    const PixelRectangle first{0, 0, 1, 1};
    drawSample(cellsOf(first).front(), 0, first);
    waitForFirst();
    times_.firstDraw = watch.lap_ms();
}

void RasterRenderer::build()
{
    if (!texts_.surface.fragment.empty())
        surface_ = buildProgram(texts_.surface);
    if (!texts_.caster.fragment.empty())
        caster_ = buildProgram(texts_.caster);
    sky_ = buildProgram(texts_.sky);
    SourceText add = linesOf("#version 330 core", "generated");
    const SourceText lines = readSource(view_.glslFolder / "raster" / "add.frag");
    add.insert(add.end(), lines.begin(), lines.end());
    add_ = buildProgram({{}, add, {"u_sample", "u_sample_origin_px"}});
}

void RasterRenderer::makeMeshes()
{
    const bool apart = raster_->method.shading == Shading::flat;
    for (const auto& object : raster_->prepared.packed.objects) {
        if (meshes_.contains(object.kind))
            continue;
        const bool endless = object.kind == packed::KIND_PLANE && hasEndlessPlanes(raster_->method);
        const Mesh mesh =
            endless ? endlessPlane() : dioptre::meshOf(object.kind, raster_->method.facets, apart);
        meshes_.emplace(object.kind, uploadMesh(mesh, apart));
    }
}

void RasterRenderer::makeShadows()
{
    shadowsDrawn_ = false;
    const auto& views = raster_->shadows.views;
    if (views.empty())
        return;
    if (!shadows_)
        shadows_ =
            makeShadowMaps(raster_->prepared.scene.raster.shadowMap_px, static_cast<int>(views.size()));
    std::vector<float> values;
    const auto* numbers = reinterpret_cast<const double*>(views.data());
    std::transform(numbers, numbers + views.size() * sizeof(packed::ShadowView) / sizeof(double),
                   std::back_inserter(values), [](double number) { return static_cast<float>(number); });
    std::erase_if(device_.blocks, [](const BoundBlock& block) { return block.block == "ShadowBlock"; });
    device_.blocks.push_back({"ShadowBlock", uploadUniformBuffer(values), values.size() * sizeof(float)});
}

void RasterRenderer::see()
{
    // Patches have moved into the packed shapes after the plan was made: upload() has taken them with it.
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
    std::erase_if(device_.blocks, [](const BoundBlock& block) { return block.block == "ShadowBlock"; });
    uploadNumbers(device_, raster.prepared.packed);
    makeShadows();
    see();
}

const MeshBuffer& RasterRenderer::meshOf(std::size_t object) const
{
    return meshes_.at(raster_->prepared.packed.objects[object].kind);
}

void RasterRenderer::use(const Program& program, const PixelRectangle& cell, int sample) const
{
    bind(program, device_, raster_->prepared.packed, {view_.width, view_.height}, {cell.x, cell.y});
    glUniform1i(locationOf(program, "u_sample_first"), sample);
    glUniform1f(locationOf(program, "u_near_m"), static_cast<GLfloat>(raster_->near_m));
    if (!shadows_)
        return;
    glUniform1f(locationOf(program, "u_shadow_bias"),
                static_cast<GLfloat>(raster_->prepared.scene.raster.shadowBias));
    if (const GLint maps = locationOf(program, "u_shadow_maps"); maps >= 0) {
        const auto unit = static_cast<GLint>(device_.textures.size()); // bind() has the ones before
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
        glBindTexture(GL_TEXTURE_2D_ARRAY, shadows_->distances.name());
        glUniform1i(maps, unit);
        glActiveTexture(GL_TEXTURE0);
    }
}

// Every object in the order of their ids, so that of two at one depth the first stays. No side is drawn that
// cannot be seen.
void RasterRenderer::drawObjects(const Program& program) const
{
    const auto& objects = raster_->prepared.packed.objects;
    const glm::dvec3 eye(raster_->prepared.packed.camera.eye);
    const GLint object = locationOf(program, "u_object");
    const GLint side = locationOf(program, "u_side");
    glEnable(GL_CULL_FACE);
    for (std::size_t id = 0; id < objects.size(); ++id) {
        if (!seen_[id])
            continue;
        glUniform1i(object, static_cast<GLint>(id));
        const SeenSides sides = sidesSeenFrom(objects[id], eye);
        if (sides.outer) {
            glCullFace(GL_BACK);
            glUniform1f(side, 1.0F);
            dioptre::draw(meshOf(id));
        }
        if (sides.inner) {
            glCullFace(GL_FRONT);
            glUniform1f(side, -1.0F);
            dioptre::draw(meshOf(id));
        }
    }
    glDisable(GL_CULL_FACE);
}

void RasterRenderer::drawShadowMaps()
{
    if (!caster_ || shadowsDrawn_)
        return;
    glBindFramebuffer(GL_FRAMEBUFFER, shadows_->framebuffer.name());
    glViewport(0, 0, shadows_->side, shadows_->side);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_DEPTH_CLAMP);
    use(*caster_, {}, 0);
    const auto& packed = raster_->prepared.packed;
    for (std::size_t light = 0; light < raster_->shadows.lights.size(); ++light) {
        const auto& views = raster_->shadows.lights[light];
        const auto glowing = static_cast<int>(packed.lights[light].diffuse.w);
        for (int layer = views.first; layer < views.first + views.count; ++layer) {
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, shadows_->distances.name(), 0,
                                      layer);
            const std::array<GLfloat, 4> farAway{1e30F, 0.0F, 0.0F, 0.0F};
            const GLfloat deepest = 1.0F;
            glClearBufferfv(GL_COLOR, 0, farAway.data());
            glClearBufferfv(GL_DEPTH, 0, &deepest);
            glUniform1i(locationOf(*caster_, "u_shadow_view"), layer);
            for (std::size_t id = 0; id < packed.objects.size(); ++id) {
                if (!raster_->casts[id] || static_cast<int>(id) == glowing)
                    continue;
                glUniform1i(locationOf(*caster_, "u_object"), static_cast<GLint>(id));
                dioptre::draw(meshOf(id));
            }
        }
    }
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
    shadowsDrawn_ = true;
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
    drawShadowMaps();
    glBindFramebuffer(GL_FRAMEBUFFER, sample_->framebuffer.name());
    glViewport(-cell.x, -cell.y, view_.width, view_.height);
    glEnable(GL_SCISSOR_TEST);
    glScissor(wanted.x - cell.x, wanted.y - cell.y, wanted.width, wanted.height);
    const std::array<GLfloat, 4> black{};
    const GLfloat deepest = 1.0F;
    glClearBufferfv(GL_COLOR, 0, black.data());
    glClearBufferfv(GL_DEPTH, 0, &deepest);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glEnable(GL_DEPTH_CLAMP);
    if (surface_) {
        use(*surface_, cell, sample);
        drawObjects(*surface_);
    }
    // The full-screen triangle lies at depth 0 of -1..1: the sky is drawn behind everything.
    glDepthRange(1.0, 1.0);
    glDepthFunc(GL_LEQUAL);
    glViewport(0, 0, sample_->width, sample_->height);
    use(sky_, cell, sample);
    glBindVertexArray(noVertices_.name());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthRange(0.0, 1.0);
    glDisable(GL_DEPTH_CLAMP);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
}

void RasterRenderer::drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area)
{
    const PixelRectangle shown = common(area, region_);
    for (const PixelRectangle& cell : cellsOf(shown))
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

DrawingFacts RasterRenderer::facts() const
{
    DrawingFacts facts;
    facts.shader = texts_.surface.fragment.empty() ? texts_.sky.fragment : texts_.surface.fragment;
    const Program& program = surface_ ? *surface_ : sky_;
    facts.uniforms = keysOf(program.uniforms);
    facts.blocks = keysOf(program.uniformBlocks);
    facts.textureBytes = device_.textureBytes;
    for (const auto& texture : device_.textures)
        facts.textures.push_back(texture.uniform);
    RasterFacts raster;
    for (std::size_t id = 0; id < seen_.size(); ++id) {
        raster.drawn += seen_[id] ? 1 : 0;
        raster.culled += seen_[id] ? 0 : 1;
        raster.triangles += seen_[id] ? meshOf(id).count / 3 : 0;
    }
    if (shadows_) {
        raster.shadowMaps = shadows_->layers;
        raster.shadowMap_px = shadows_->side;
        facts.textures.emplace_back("u_shadow_maps");
        facts.textureBytes += 4UL * static_cast<std::size_t>(shadows_->layers) *
                              static_cast<std::size_t>(shadows_->side) *
                              static_cast<std::size_t>(shadows_->side);
    }
    facts.raster = raster;
    return facts;
}

} // namespace dioptre
