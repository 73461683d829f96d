// Dioptre's own kernels, included: a ball before a plain ground.
// expect: 4,2 = 1 0 0
// expect: 0,0 = 0 0 1
#include "shared/constants.glsl"
#include "kernel/ray.glsl"
#include "kernel/sphere.glsl"
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    Ray ray;
    ray.origin = vec3(0.0, 0.0, 4.0);
    ray.direction = normalize(vec3((2.0 * fragCoord - iResolution.xy) / iResolution.y, -2.0));
    ray.from = -1;
    Crossing crossing = sphereCrossing(ray, 0, vec3(0.0), 1.0);
    fragColor = crossing.found ? vec4(1.0, 0.0, 0.0, 1.0) : vec4(0.0, 0.0, 1.0, 1.0);
}
