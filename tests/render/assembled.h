// The program of a scene that is given as text.
#pragma once

#include "render/assemble.h"
#include "render/pack.h"
#include "scene/load.h"

#include <string>

namespace dioptre
{

struct Assembled {
    Plan plan;
    std::string fragment;
    std::string vertex;
};

// The scene finds the gallery's pictures.
inline Assembled assembled(const std::string& toml)
{
    const std::filesystem::path glsl = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";
    const Scene scene = underLightType(parseScene(toml, glsl / "scenes" / "text.toml", {}, 0.0, {{}, glsl}));
    Assembled result{makePlan(scene), {}, {}};
    auto packed = pack(scene, result.plan, {36, 1});
    loadPictures(scene, result.plan, packed);
    result.fragment = flatten(assemble(scene, result.plan, packed, glsl));
    result.vertex = flatten(assembleVertex(result.plan, packed, glsl));
    return result;
}

} // namespace dioptre
