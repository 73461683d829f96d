// What the host feeds. A shader holds only those that its scene needs; the host's table and the linked program's list are
// compared both ways.

uniform int u_sample_first;    // index of the first sample of this draw
uniform int u_sample_count;    // samples in this draw
uniform int u_depth;           // most bounces of a path

#ifdef HAS_SHARED_VIEW
// What all pixels share comes through the vertex stage where it can: software drivers gather a uniform for every pixel, at
// some twenty instructions a number, and a flat input is one instruction. receiveShared() fills these in.
vec2 u_resolution;     // whole picture, pixels
vec2 u_tile_origin_px; // lower left corner of what is drawn, in the whole picture
int u_budget;          // rays a sample, the eye ray included
float u_cut_off;       // a path of smaller weight is cut
vec3 u_ambient;        // ambient light from everywhere
Camera u_camera;
Sky u_sky;
#else
uniform vec2 u_resolution;
uniform vec2 u_tile_origin_px;
uniform int u_budget;
uniform float u_cut_off;
uniform vec3 u_ambient;
layout(std140) uniform CameraBlock
{
    Camera u_camera;
};
layout(std140) uniform SkyBlock
{
    Sky u_sky;
};
#endif
#ifdef HAS_SHARED_MATERIALS
Material shared_materials[MATERIAL_COUNT]; // as far as there is room; the rest is read from the block
#endif
layout(std140) uniform MaterialBlock
{
    Material u_materials[MATERIAL_COUNT];
};
#ifdef HAS_SHARED_LIGHTS
Light u_lights[LIGHT_COUNT];
#else
layout(std140) uniform LightBlock
{
    Light u_lights[LIGHT_COUNT];
};
#endif
// The table that scene_table.glsl reads.
layout(std140) uniform ShapeBlock
{
    Shape u_shapes[SHAPE_COUNT];
    vec4 u_index[SHAPE_COUNT];
    vec4 u_kind_first[KIND_COUNT + 1];
};
// Geometry of the objects that move, where that of the others stands in the text.
layout(std140) uniform MovingBlock
{
    Shape u_moving[MOVING_COUNT];
};

// And what is read besides of those that have kernels of their own.
layout(std140) uniform FineBlock
{
    FineShape u_fine[MOVING_COUNT];
};

uniform sampler2D u_sky_picture; // latitude-longitude, linear radiance
