// Bytes as a scene's text: loaded, written to, planned, packed and assembled.
#include "fuzz.h"

#include "render/assembled_part.h"
#include "render/prepare.h"
#include "scene/document_edit.h"
#include "scene/load.h"

using namespace dioptre;

namespace
{

// One texel for each picture that the plan asks for: what files hold is the picture target's.
void giveTexels(const Scene& scene, const Plan& plan, PackedScene& packed)
{
    const Picture grey{1, 1, PixelFormat::srgb8, {128, 128, 128, 255}, {}};
    packed.pictures.assign(plan.pictures.size(), {grey});
    if (plan.has("sky picture") && scene.sky.kind == Sky::Kind::image)
        packed.sky_picture = {grey};
}

// The text's first comment, if it reads "#=path=value", is an override.
std::vector<std::string> overridesIn(const std::string& text)
{
    constexpr std::string_view mark = "#=";
    if (!text.starts_with(mark))
        return {};
    return {text.substr(mark.size(), text.find('\n') - mark.size())};
}

void assembleAll(const Scene& scene)
{
    const ViewSettings view{.width = 320, .height = 180, .glslFolder = fuzz::glslOfSources};
    const PreparedScene prepared = prepare(scene, view, giveTexels);
    for (const auto& part : assembleParts(prepared, fuzz::glslOfSources, {15, Guard::unit}))
        fuzz::demand(!part.shader.empty() && !part.vertex.empty());
}

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const std::filesystem::path folder = fuzz::emptyFolder();
    const std::string text = fuzz::textOf(data, size);
    const std::filesystem::path path = folder / "scene.toml";
    const SearchPlaces places{{}, fuzz::glslOfSources};
    const auto overrides = overridesIn(text);
    if (!overrides.empty())
        fuzz::succeeds([&] { withValues(text, path.string(), overrides); });
    fuzz::succeeds([&] {
        const SceneOverTime scenes = parseSceneOverTime(text, path, overrides, places);
        fuzz::succeeds([&] { assembleAll(scenes(0.0)); });
        for (const double time_s : {-1.0, 0.3, 1e300})
            fuzz::succeeds([&] { scenes(time_s); });
    });
    return 0;
}
