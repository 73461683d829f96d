// A light's height at rest, and a declaration's own value that stays.
// expect: 0,0 = 0.3 0.5 1.0
uniform float u_light_height;
uniform float u_light_type = 5.0;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(0.1 * u_light_height, 0.1 * u_light_type, 1.0, 1.0);
}
