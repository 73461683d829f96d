// What the host feeds the rasterised methods, besides what trace/uniforms.glsl has.

uniform float u_side;        // 1: its outer or front side is drawn; -1: the other
uniform float u_near_m;      // no surface is nearer to the eye
uniform vec3 u_eye_absorption; // per metre, of the medium that the eye is in
uniform int u_shadow_view;   // whose map is drawn
uniform float u_shadow_bias; // see seesLight()

#ifdef HAS_SHADOW_MAPS
layout(std140) uniform ShadowBlock
{
    ShadowView u_shadow_views[SHADOW_VIEW_COUNT];
    vec4 u_shading_planes[SHADING_PLANE_COUNT]; // xyz: unit normal; w: its dot product with the plane's point
};
uniform sampler2DArray u_shadow_maps; // a layer a view: how far its light gets, metres
#endif
