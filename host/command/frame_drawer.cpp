#include "command/frame_drawer.h"

#include "base/clock.h"
#include "base/file.h"
#include "base/text.h"
#include "command/plain_options.h"
#include "command/render_steps.h"
#include "kernel/reference.h"
#include "render/assemble.h"

#include <fmt/format.h>

#include <future>

namespace dioptre
{

FrameDrawer::FrameDrawer(const RenderOptions& options, const Input& input, double first_s)
    : input_(input), settings_(stillSettingsOf(options)),
      text_(input.plainShader ? readFile(input.path) : readSceneText(input.path)),
      context_{"reference", "double precision on the CPU", "", true}
{
    if (input.plainShader) {
        plain_ = plainSettings(options);
        plain_.frame.rate = options.fps;
        startVariablesAtZero();
    }
    Stopwatch watch;
    std::future<PreparedScene> preparing; // beside the making of the context
    if (!input.plainShader) {
        scene_ = parseSceneOverTime(text_, input.path, options.overrides);
        preparing = std::async(std::launch::async, [scene = scene_(first_s), settings = settings_] {
            return prepare(scene, settings);
        });
    }
    made_.load = watch.lap_ms();
    if (!options.reference) {
        glContext_ = makeContext(options.backend);
        context_ = glContext_->info();
        made_.context = watch.lap_ms();
    }
    if (input.plainShader) {
        plain_.frame.time_s = first_s;
        plainRenderer_ = std::make_unique<PlainRenderer>(input.path, settings_, plain_);
        addTimes(plainRenderer_->times());
        return;
    }
    prepared_ = preparing.get();
    made_.load += watch.lap_ms(); // what the making of the context did not hide
    if (options.reference)
        return;
    renderer_ = std::make_unique<Renderer>(*prepared_, settings_, context_);
    addTimes(renderer_->times());
}

void FrameDrawer::addTimes(const BuildTimes& times)
{
    made_.load += times.load;
    made_.compile = times.compile;
    made_.firstDraw = times.firstDraw;
}

Still FrameDrawer::draw(double time_s, const std::function<void(double)>& progress)
{
    settings_.progress = progress;
    if (plainRenderer_) {
        plain_.frame.time_s = time_s;
        plainRenderer_->moveTo(plain_.frame);
        return drawPlain(*plainRenderer_, progress);
    }
    Stopwatch watch;
    moveTo(*prepared_, scene_(time_s), settings_);
    if (renderer_)
        renderer_->update(*prepared_);
    const double load_ms = watch.lap_ms();
    Still still = renderer_ ? drawFrame(*renderer_, settings_) : renderReferenceStill(*prepared_, settings_);
    still.phases.load += load_ms;
    return still;
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

std::string FrameDrawer::plainSources() const
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

unsigned long long FrameDrawer::sourcesFingerprint() const
{
    std::string all = text_ + "\n";
    if (prepared_)
        addPictures(all, *prepared_);
    if (renderer_)
        for (const auto& part : renderer_->parts())
            all += flatten(part.shader) +
                   flatten(assembleVertex(part.plan, prepared_->packed, settings_.glslFolder));
    if (input_.plainShader)
        all += plainSources();
    if (!input_.plainShader && !renderer_)
        all += fmt::format("{:016x}\n", compiledShaderFingerprint());
    return fingerprint(all);
}

} // namespace dioptre
