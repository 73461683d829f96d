// Of the facets' edges.

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "trace/uniforms.glsl"
#include "raster/uniforms.glsl"
#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "raster/object.glsl"
#include "raster/unit_shape.glsl"
#include "raster/cell.glsl"
#include "raster/project.glsl"

layout(location = 0) in vec4 a_place; // on the unit shape

out vec4 v_place; // scene frame, homogeneous

void main()
{
    v_place = placeInScene(a_place, drawnKind(), drawnShape());
    gl_Position = clipFromScene(v_place);
}
