// What the nearest object is, as selects between constants and uniforms of known index: no gather from a
// table, and only the values that some object or material of the scene needs.
#pragma once

#include "kernel/packed_scene.h"
#include "render/plan.h"

#include <functional>
#include <optional>
#include <string>

namespace dioptre
{

// The value of each of `count` items, nothing where it does not matter, as one expression on the int `name`:
// "object < 3 ? a : b" where neighbours share values, "object == 4 ? a : b" where one value stands out.
// `rest` is the value where none matters.
std::string selectText(const std::string& name, std::size_t count,
                       const std::function<std::optional<std::string>(std::size_t)>& valueOf,
                       const std::string& rest);

// "shared_materials[2]" or "u_materials[2]": where a transparent object's shadow finds its numbers.
std::string shadowMaterial(const Plan& plan, std::size_t i);

// materialOf(), and absorptionOf() where media absorb.
std::string materialText(const Scene& scene, const Plan& plan);
std::string absorptionText(const Scene& scene, const Plan& plan);

// kindOf(), shapeOf(), mediumOf(), materialOf() and absorptionOf(), as far as the scene needs them.
std::string lookupText(const Scene& scene, const PackedScene& packed, const Plan& plan);

} // namespace dioptre
