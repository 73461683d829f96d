#include "command/picture_drawer.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "command/plain_options.h"
#include "kernel/reference.h"
#include "render/assemble.h"

#include <fmt/format.h>

#include <future>

namespace dioptre
{
namespace
{

// Pixels on a side that are drawn at once: every driver can, and it is a multiple of 64.
constexpr int sideAtOnce = 8192;

ViewSettings viewSettingsOf(const RenderOptions& options, int rowsAtOnce)
{
    ViewSettings settings{options.width, options.height, options.samples,
                          glslFolder(),  pictureCache(), dataViewNamed(options.view)};
    settings.widthAtOnce = sideAtOnce;
    settings.heightAtOnce = std::min(rowsAtOnce, sideAtOnce);
    settings.drawLimit_s = options.drawLimit_s;
    return settings;
}

void refuseEditedShader(const std::filesystem::path& glsl)
{
    if (shaderFingerprint(glsl) != compiledShaderFingerprint())
        fail(ExitCode::badInput, glsl.string() + " was edited after the reference was compiled from it",
             "build again: the reference speaks only for the sources that it was made from");
}

} // namespace

PictureDrawer::PictureDrawer(const RenderOptions& options, const Input& input, double first_s, int rowsAtOnce)
    : method_(methodNamed(options.method)), input_(input), settings_(viewSettingsOf(options, rowsAtOnce)),
      text_(input.plainShader ? readFile(input.path) : readSceneText(input.path)),
      context_{"reference", "double precision on the CPU", "", true}
{
    if (input.plainShader) {
        plain_ = plainSettings(options);
        if (!options.frames.empty())
            plain_.frame.rate = options.fps;
        plain_.frame.time_s = first_s;
        startVariablesAtZero();
    }
    Stopwatch watch;
    std::future<void> preparing; // beside the making of the context
    if (!input.plainShader) {
        scene_ = parseSceneOverTime(text_, input.path, options.overrides, searchPlaces(options.included));
        preparing = std::async(std::launch::async, [this, scene = scene_(first_s)] {
            if (isRasterised(method_))
                raster_ = prepareRaster(scene, settings_, method_);
            else
                prepared_ = prepare(scene, settings_);
        });
    }
    made_.load = watch.lap_ms();
    if (options.reference) {
        refuseEditedShader(settings_.glslFolder);
    } else {
        glContext_ = makeContext(options.backend);
        context_ = glContext_->info();
        made_.context = watch.lap_ms();
    }
    if (preparing.valid())
        preparing.get();
    made_.load += watch.lap_ms(); // what the making of the context did not hide
    if (!options.reference)
        makeRenderers(options);
}

void PictureDrawer::makeRenderers(const RenderOptions& options)
{
    settings_.widthAtOnce = std::min(sideAtOnce, longestTargetSide());
    settings_.heightAtOnce = std::min(settings_.heightAtOnce, longestTargetSide());
    if (input_.plainShader) {
        plainRenderer_ = std::make_unique<PlainRenderer>(input_.path, settings_, plain_, context_);
        return addTimes(plainRenderer_->times());
    }
    if (raster_) {
        rasterRenderer_ = std::make_unique<RasterRenderer>(*raster_, settings_);
        return addTimes(rasterRenderer_->times());
    }
    renderer_ = std::make_unique<Renderer>(*prepared_, settings_, context_);
    addTimes(renderer_->times());
    if (options.layers.empty())
        return;
    layers_ =
        std::make_unique<LayerDrawer>(prepared_->scene, layersNamed(options.layers), settings_, context_);
    addTimes(layers_->times());
}

void PictureDrawer::addTimes(const BuildTimes& times)
{
    made_.load += times.load;
    made_.compile += times.compile;
    made_.firstDraw += times.firstDraw;
}

DrawingFacts PictureDrawer::facts() const
{
    return drawing() != nullptr ? drawing()->facts() : DrawingFacts{};
}

Drawing* PictureDrawer::drawing() const
{
    if (plainRenderer_)
        return plainRenderer_.get();
    if (rasterRenderer_)
        return rasterRenderer_.get();
    return renderer_.get();
}

std::vector<std::string> PictureDrawer::layerChannels() const
{
    return layers_ ? layers_->channels() : std::vector<std::string>{};
}

void PictureDrawer::moveTo(double time_s)
{
    if (plainRenderer_) {
        plain_.frame.time_s = time_s;
        return plainRenderer_->moveTo(plain_.frame);
    }
    if (raster_) {
        dioptre::moveTo(*raster_, scene_(time_s), settings_);
        return rasterRenderer_->update(*raster_);
    }
    dioptre::moveTo(*prepared_, scene_(time_s), settings_);
    if (renderer_)
        renderer_->update(*prepared_);
}

Still PictureDrawer::drawReference(const PixelRectangle& rows) const
{
    Still still;
    Stopwatch watch;
    still.picture =
        renderReference(prepared_->packed, settings_.width, settings_.height, settings_.samples, rows);
    still.counts = meansOfSums(still.picture, 1);
    still.counts.rays *= settings_.samples; // a sample's mean until here
    still.phases.draw = watch.lap_ms();
    return still;
}

PictureDrawer::Band PictureDrawer::draw(const PixelRectangle& rows, const Progress& progress)
{
    if (drawing() == nullptr)
        return {drawReference(rows), {}};
    Band band{drawStill(*drawing(), rows, progress), {}};
    Stopwatch watch;
    if (layers_)
        band.layers = layers_->draw(rows);
    band.still.phases.draw += watch.lap_ms();
    return band;
}

namespace
{

void addPictures(std::string& all, const PreparedScene& prepared)
{
    std::vector<std::string> paths;
    for (const auto& picture : prepared.plan.pictures)
        paths.push_back(picture.path);
    if (prepared.plan.has("sky picture"))
        paths.push_back(prepared.scene.sky.image);
    for (const auto& path : paths)
        if (!path.empty())
            all += fmt::format("{} {:016x}\n", path, fingerprint(readFile(path)));
}

} // namespace

std::string PictureDrawer::plainSources() const
{
    std::string all = flatten(plainRenderer_->text());
    all += fmt::format("{} frames a second\n", plain_.frame.rate);
    for (const auto& channel : plain_.channels) {
        all += fmt::format("{} {} {} {}\n", static_cast<int>(channel.filter),
                           static_cast<int>(channel.wrap.value_or(TextureWrap::repeat)),
                           channel.flip.value_or(channel.kind() == ChannelKind::picture), channel.cross);
        for (const auto& file : channel.files)
            all += fmt::format("{} {:016x}\n", file, fingerprint(readFile(file)));
    }
    return all;
}

unsigned long long PictureDrawer::sourcesFingerprint() const
{
    std::string all = text_ + "\n";
    if (prepared() != nullptr)
        addPictures(all, *prepared());
    if (rasterRenderer_)
        for (const auto& text : rasterRenderer_->texts())
            all += flatten(text.vertex) + flatten(text.fragment);
    if (renderer_)
        for (const auto& part : renderer_->parts())
            all += flatten(part.shader) +
                   flatten(assembleVertex(part.plan, prepared_->packed, settings_.glslFolder));
    if (layers_)
        for (const auto& shader : layers_->shaders())
            all += flatten(shader);
    if (input_.plainShader)
        all += plainSources();
    if (drawing() == nullptr)
        all += fmt::format("{:016x}\n", compiledShaderFingerprint());
    return fingerprint(all);
}

} // namespace dioptre
