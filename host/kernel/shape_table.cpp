#include "kernel/packed_scene.h"

namespace dioptre
{

ShapeTable shapeTable(const PackedScene& scene)
{
    ShapeTable table;
    table.index.resize(scene.objects.size());
    for (int kind = 0; kind < packed::KIND_COUNT; ++kind) {
        const auto index = static_cast<std::size_t>(kind);
        table.kindFirst[index].x = static_cast<double>(table.shapes.size());
        for (std::size_t object = 0; object < scene.objects.size(); ++object) {
            if (scene.objects[object].kind != kind)
                continue;
            const auto slot = table.shapes.size();
            table.index[object].x = static_cast<double>(slot);
            table.index[object].y = kind;
            table.index[object].z = scene.objects[object].material;
            table.index[slot].w = static_cast<double>(object);
            table.shapes.push_back(scene.objects[object].shape);
        }
    }
    table.kindFirst.back().x = static_cast<double>(table.shapes.size());
    return table;
}

} // namespace dioptre
