#include "scene/sections.h"

#include "scene/direction.h"
#include "scene/table_reader.h"

namespace dioptre
{

Camera readCamera(const Table& document, const std::vector<Material>& materials)
{
    Camera camera;
    const Value* section = find(document, "camera");
    if (!section)
        return camera;
    const TableReader reader(*section, "[camera]", {"eye", "target", "fov_y_deg", "inside"});
    reader.vector("eye", camera.eye);
    reader.vector("target", camera.target);
    reader.number("fov_y_deg", camera.fovY_deg, {0.0, 180.0, true, "an angle above 0 and below 180"});
    if (coincident(camera.eye, camera.target))
        fail(ExitCode::badInput, reader.where(reader.find("target") ? "target" : "eye"),
             "the camera's eye and target are the same point", "move one of them apart");
    if (const Value* medium = reader.find("inside"))
        camera.inside = materialIndex(*medium, "inside", materials);
    return camera;
}

} // namespace dioptre
