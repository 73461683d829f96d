// Saved on another system, with macros of one letter and functions that only the site calls.
// expect: 0,0 = 0.5 0.25 1
#define R iResolution
#define T iTime
#define c cos
#define O fragColor
#define rgb xyz
void mainImage(out vec4 O, vec2 U)
{
    O.rgb = vec3(0.5, 0.25 + 0.0 * U.x / R.x, c(T));
}
void mainVR(out vec4 O, in vec2 U, in vec3 from, in vec3 towards)
{
    mainImage(O, U);
}
vec2 mainSound(float time)
{
    return vec2(sin(time));
}
