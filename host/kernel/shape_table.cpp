#include "kernel/packed_scene.h"

#include <functional>

namespace dioptre
{
namespace
{

// Appends those objects of a kind for which `takes`.
void append(ShapeTable& table, const PackedScene& scene, int kind,
            const std::function<bool(const PackedObject&)>& takes)
{
    for (std::size_t id = 0; id < scene.objects.size(); ++id) {
        const PackedObject& object = scene.objects[id];
        if (object.kind != kind || !takes(object))
            continue;
        const auto slot = table.shapes.size();
        table.index[id].x = static_cast<double>(slot);
        table.index[id].y = kind;
        table.index[id].z = object.material;
        table.index[slot].w = static_cast<double>(id);
        table.shapes.push_back(object.shape);
    }
}

ShapeTable tableOf(const PackedScene& scene, const std::function<bool(const PackedObject&)>& amongKind)
{
    ShapeTable table;
    table.index.resize(scene.objects.size());
    for (int kind = 0; kind < packed::KIND_COUNT; ++kind) {
        table.kindFirst[static_cast<std::size_t>(kind)].x = static_cast<double>(table.shapes.size());
        append(table, scene, kind, amongKind);
    }
    table.kindFirst.back().x = static_cast<double>(table.shapes.size());
    for (int kind = 0; kind < packed::KIND_COUNT; ++kind)
        append(table, scene, kind, std::not_fn(amongKind));
    return table;
}

} // namespace

ShapeTable shapeTable(const PackedScene& scene)
{
    return tableOf(scene, [](const PackedObject& object) { return !object.apart; });
}

ShapeTable plainShapeTable(const PackedScene& scene)
{
    ShapeTable table = tableOf(scene, [](const PackedObject&) { return true; });
    if (scene.objects.empty()) {
        table.shapes.emplace_back();
        table.index.emplace_back(0.0);
    }
    return table;
}

} // namespace dioptre
