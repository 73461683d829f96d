// What the host feeds. A shader holds only those that its scene needs; the host's table and the linked program's list are
// compared both ways.

uniform vec2 u_resolution;     // whole picture, pixels
uniform vec2 u_tile_origin_px; // lower left corner of what is drawn, in the whole picture
uniform int u_sample_first;    // index of the first sample of this draw
uniform int u_sample_count;    // samples in this draw
uniform int u_budget;          // rays a sample, the eye ray included
uniform float u_cut_off;       // a path of smaller weight is cut
uniform int u_depth;           // most bounces of a path
uniform vec3 u_ambient;        // ambient light from everywhere

layout(std140) uniform CameraBlock
{
    Camera u_camera;
};
layout(std140) uniform SkyBlock
{
    Sky u_sky;
};
layout(std140) uniform MaterialBlock
{
    Material u_materials[MATERIAL_COUNT];
};
layout(std140) uniform LightBlock
{
    Light u_lights[LIGHT_COUNT];
};
// The table that scene_loop.glsl reads.
layout(std140) uniform ShapeBlock
{
    Shape u_shapes[SHAPE_COUNT];
    vec4 u_index[SHAPE_COUNT];
    vec4 u_kind_first[KIND_COUNT + 1];
};

uniform sampler2D u_sky_picture; // latitude-longitude, linear radiance
