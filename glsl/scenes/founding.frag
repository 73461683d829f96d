// The founding way: a scene written in the shader itself. The tracer is dioptre's, included; what stands here is what the
// host writes for a scene file: the objects, their materials, the light and the camera.

// What this scene needs of the tracer.
#define HAS_OBJECTS
#define HAS_SPHERE
#define HAS_ROUND_SHAPE
#define HAS_PLANE
#define HAS_FLAT
#define HAS_COORDINATES
#define HAS_PLANE_COORDINATES
#define HAS_CHECKER
#define HAS_MIRROR_RAY
#define HAS_LOCAL
#define HAS_ANY_AMBIENT
#define HAS_AMBIENT
#define HAS_LIGHTS
#define HAS_DIRECTIONAL_LIGHT
#define HAS_SHADOWS
#define HAS_SKY_GRADIENT

#include "shared/constants.glsl"
#include "shared/structs.glsl"
#include "kernel/ray.glsl"
#include "kernel/sphere.glsl"
#include "kernel/flat.glsl"
#include "kernel/lat_long.glsl"

uniform vec2 u_resolution;
uniform float u_time;
uniform float u_radius = 1.0; // 1.0 [0.2, 1.4] of the mirror ball, metres

// Uniform data of a scene file; here they are set below.
Camera u_camera;
Sky u_sky;
Light sun;
vec3 u_ambient;
const int u_budget = 8;
const float u_cut_off = 1.0 / 512.0;

#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "trace/nearest.glsl"

const int BALL = 0;
const int MOON = 1;
const int FLOOR = 2;

vec3 ballCentre()
{
    return vec3(0.0, u_radius, 0.0);
}

// Round the ball once in eight seconds.
vec3 moonCentre()
{
    float angle = 0.25 * PI * u_time;
    return vec3(1.9 * cos(angle), 0.45, 1.9 * sin(angle));
}

Nearest nearestHit(Ray ray)
{
    Nearest nearest = nothingYet();
    nearest = nearer(nearest, sphereCrossing(ray, BALL, ballCentre(), u_radius), BALL);
    nearest = nearer(nearest, sphereCrossing(ray, MOON, moonCentre(), 0.45), MOON);
    nearest = nearer(nearest, planeCrossing(ray, FLOOR, vec3(0.0), vec3(0.0, 1.0, 0.0)), FLOOR);
    return nearest;
}

vec3 lightThrough(Ray ray, float distance, int glowing)
{
    float open = unblocked(sphereCrossing(ray, BALL, ballCentre(), u_radius), distance);
    open *= unblocked(sphereCrossing(ray, MOON, moonCentre(), 0.45), distance);
    return vec3(open);
}

int kindOf(int object)
{
    return object == FLOOR ? KIND_PLANE : KIND_SPHERE;
}

Shape shapeOf(int object)
{
    Shape shape;
    shape.anchor = object == BALL ? vec4(ballCentre(), u_radius) : object == MOON ? vec4(moonCentre(), 0.45) : vec4(0.0);
    shape.axis = vec4(0.0, 1.0, 0.0, 0.0);
    shape.along_u = vec4(1.0, 0.0, 0.0, 0.0);
    shape.along_v = vec4(0.0, 0.0, -1.0, 0.0);
    return shape;
}

Material materialOf(int object)
{
    Material material;
    material.colour = vec4(object == MOON ? vec3(0.8, 0.25, 0.1) : vec3(1.0), -1.0);
    material.ambient = vec4(0.0, 0.0, 0.0, 1.0);
    material.mirror = object == BALL ? vec4(0.9, 0.88, 0.8, 0.9) : vec4(0.0);
    material.checker = vec4(0.12, 0.16, 0.25, object == FLOOR ? 0.8 : 0.0);
    material.checker_first = vec4(0.75, 0.72, 0.65, 1.0);
    return material;
}

#include "trace/surface.glsl"
#include "trace/light.glsl"

vec3 lightsReflected(Surface surface, Material material, Ray ray, int object, bool inside)
{
    return lightReflected(sun, directionalIncidence(sun), -1, surface, material, ray, object, inside);
}

#include "trace/sky.glsl"
#include "trace/scatter.glsl"
#include "trace/chain.glsl"

void placeCameraAndLights()
{
    vec3 eye = vec3(0.0, 2.0, 6.0);
    vec3 back = normalize(eye - vec3(0.0, 0.8, 0.0));
    vec3 right = normalize(cross(vec3(0.0, 1.0, 0.0), back));
    float slope = tan(radians(20.0));
    u_camera.eye = vec4(eye, -1.0);
    u_camera.right = vec4(slope * right, 0.0);
    u_camera.up = vec4(slope * cross(back, right), 0.0);
    u_camera.forward = vec4(-back, 0.0);
    u_sky.colour = vec4(0.5, 0.45, 0.4, 0.0);
    u_sky.horizon = vec4(0.75, 0.8, 0.9, 0.0);
    u_sky.zenith = vec4(0.15, 0.3, 0.65, 0.0);
    sun.direction = vec4(normalize(vec3(-0.5, -1.0, -0.4)), 0.0);
    sun.diffuse = vec4(1.0, 0.95, 0.85, -1.0);
    u_ambient = vec3(0.15, 0.18, 0.24);
}

// A plain shader encodes its own picture: IEC 61966-2-1.
vec3 srgbEncoded(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    return mix(12.92 * c, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

void main()
{
    placeCameraAndLights();
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i)
        sum += traceChain(eyePath(gl_FragCoord.xy + sampleOffset(i))).xyz;
    gl_FragColor = vec4(srgbEncoded(0.25 * sum), 1.0);
}
