// The tracer of glsl/ as C++ in double precision, with every shape, way of tracing and order of the ray tree.
// What it needs for light or for another account of the paths is defined before. Include inside a namespace
// of its own, behind kernel/glsl_as_cpp.h. NOLINTBEGIN: no include guard, this is a fragment

#define HAS_OBJECTS
#define HAS_SPHERE
#define HAS_OPEN_CYLINDER
#define HAS_CAPPED_CYLINDER
#define HAS_CYLINDER
#define HAS_ROUND_SHAPE
#define HAS_PLANE
#define HAS_DISK
#define HAS_RECTANGLE
#define HAS_TRIANGLE
#define HAS_FLAT
#define HAS_MIRROR_RAY
#define HAS_REFRACTION
#define HAS_ABSORPTION
#define HAS_DEPTH_LIMIT
#define SHAPE_COUNT u_shape_count
#define FIRST_POINT_LIGHT u_first_point
#define FIRST_SPOT_LIGHT u_first_spot
#define FIRST_GLOW u_first_glow
#define LIGHT_COUNT u_light_count
#define QUEUE_SLOTS 4096 // the largest budget: no more rays than that are ever asked for

// GLSL reads float; here it computes in double.
#define float double
#define HAS_DOUBLE

#include "shared/constants.glsl"
using packed::Camera;
using packed::Light;
using packed::Material;
using packed::Shape;
using packed::Sky;

// Set once before the threads start, read by all of them.
static vec2 u_resolution;
static int u_budget, u_depth, u_shape_count, u_first_point, u_first_spot, u_first_glow, u_light_count;
static double u_cut_off;
static vec3 u_ambient;
static Camera u_camera;
static Sky u_sky;
static const Material* u_materials;
static const Light* u_lights;
static const Shape* u_shapes;
static const vec4* u_index;
static const vec4* u_kind_first;

// In the order of ray_trace.frag.
// clang-format off
#include "kernel/ray.glsl"
#include "kernel/sphere.glsl"
#include "kernel/cylinder.glsl"
#include "kernel/flat.glsl"
#include "kernel/dielectric.glsl"
#include "kernel/lobe.glsl"
#include "kernel/microfacet.glsl"
#include "kernel/lat_long.glsl"
#ifdef HAS_TRUST
#include "kernel/blur.glsl"
#endif
#include "trace/path.glsl"
#include "trace/camera.glsl"
#include "trace/nearest.glsl"
#include "trace/scene_table.glsl"
#include "trace/scene_loop.glsl"
#include "trace/surface.glsl"
#include "trace/light.glsl"
#include "trace/sky.glsl"
#ifdef HAS_TRUST
#include "trace/trust.glsl"
#endif
#include "trace/scatter.glsl"
#include "trace/single.glsl"
#include "trace/chain.glsl"
#include "trace/breadth_first.glsl"
#include "trace/depth_first.glsl"
// clang-format on
namespace pool_of_3
{
#define POOL_SLOTS 3
#include "trace/heaviest_first.glsl"
#undef POOL_SLOTS
} // namespace pool_of_3
namespace pool_of_4
{
#define POOL_SLOTS 4
#include "trace/heaviest_first.glsl"
} // namespace pool_of_4
#undef float

static vec4 traceTree(const PackedScene& scene, const Path& eye)
{
    switch (scene.tree) {
    case RayTree::single:
        return traceSingle(eye);
    case RayTree::chain:
        return traceChain(eye);
    case RayTree::heaviestFirst:
        return scene.poolSlots == 4 ? pool_of_4::traceHeaviestFirst(eye) : pool_of_3::traceHeaviestFirst(eye);
    case RayTree::breadthFirst:
        return traceBreadthFirst(eye);
    case RayTree::depthFirst:
        return traceDepthFirst(eye);
    }
    return vec4(0.0);
}

// Points what the tracer reads at the scene; `table` must outlive the rendering.
static void setTracer(const PackedScene& scene, const ShapeTable& table, int width, int height)
{
    u_resolution = vec2(width, height);
    u_budget = scene.budget;
    u_depth = scene.depth;
    u_cut_off = scene.cutOff;
    u_ambient = scene.ambient;
    u_camera = scene.camera;
    u_sky = scene.sky;
    u_shape_count = static_cast<int>(scene.objects.size());
    u_first_point = scene.firstPoint;
    u_first_spot = scene.firstSpot;
    u_first_glow = scene.firstGlow;
    u_light_count = static_cast<int>(scene.lights.size());
    // An object that is not there is computed and not taken: see scatter().
    static Material nothing{};
    nothing.colour.w = -1.0;
    u_materials = scene.materials.empty() ? &nothing : scene.materials.data();
    u_lights = scene.lights.data();
    u_shapes = table.shapes.data();
    u_index = table.index.data();
    u_kind_first = table.kindFirst.data();
}

// Row y of the picture, whose lower left pixel is `corner` of the whole.
static void renderRow(const PackedScene& scene, const vec2& corner, int y, int samples, Picture& picture)
{
    for (int x = 0; x < picture.width; ++x) {
        Interruption::check(); // a pixel of many samples takes a while
        vec4 sum(0.0);
        for (int i = 0; i < samples; ++i)
            sum += traceTree(scene, eyePath(corner + vec2(x + 0.5, y + 0.5) + sampleOffset(i)));
        const auto pixel = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                static_cast<std::size_t>(x));
        for (int channel = 0; channel < 4; ++channel)
            picture.floats[pixel + static_cast<std::size_t>(channel)] =
                static_cast<float>(sum[channel] / samples);
    }
}

// float32 means of the samples, rows from the bottom up, on all cores; alpha holds the rays traced a sample.
// Of what was set.
static Picture traceRegion(const PackedScene& scene, int samples, const PixelRectangle& region)
{
    Picture picture = blankFloats(region.width, region.height);
    const vec2 corner(region.x, region.y);
    inParallel(static_cast<std::size_t>(region.height),
               [&](std::size_t y) { renderRow(scene, corner, static_cast<int>(y), samples, picture); });
    return picture;
}

// NOLINTEND
