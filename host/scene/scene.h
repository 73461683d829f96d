// A scene as its author wrote it: doubles, metres, linear colours; degrees only where the name says so.
#pragma once

#include "base/error.h"
#include "base/picture.h"
#include "base/tone_curve.h"

#include <glm/glm.hpp>

#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace dioptre
{

// The eye. Right-handed, y up, looking along -z at rest, as OpenGL, GLM and glTF.
struct Camera {
    glm::dvec3 eye{0.0, 1.6, 5.0};
    glm::dvec3 target{0.0, 0.0, 0.0};
    double fovY_deg = 42.0;
    std::optional<std::size_t> inside; // index of the material whose medium the eye is in
};

// What a ray sees that leaves the scene. One of colour, gradient, image; colour (0,0,0) where nothing is
// said.
struct Sky {
    enum class Kind { colour, gradient, image };
    Kind kind = Kind::colour;
    glm::dvec3 colour{0.0};
    std::vector<glm::dvec3> gradient; // three: nadir, horizon, zenith; mixed by |sine of the elevation|
    std::string image;                // path, resolved against the scene's folder
    Encoding encoding = Encoding::automatic;
    double rotation_deg = 0.0; // turns the picture about +y, counter-clockwise seen from above
    bool mirrorU = false;      // the picture's u runs the other way
    double exposure = 0.0;     // stops: radiance is multiplied by 2^exposure
};

enum class TreeOrder { heaviestFirst, breadthFirst, depthFirst };
enum class SceneForm { literal, loop };

// 0: unlit colours, mirrors stay. 1: lights and ambient. 2: lights only: no ambient, black sky.
enum class LightType { unlit = 0, lit = 1, lightsOnly = 2 };

struct Trace {
    std::optional<int> budget; // rays a sample, the eye ray included; the plan's default where unset
    std::optional<int> depth;  // most bounces of a path; unbounded where unset
    double cutOff = 1.0 / 512.0;
    TreeOrder order = TreeOrder::heaviestFirst;
    SceneForm form = SceneForm::literal;
    LightType lightType = LightType::lit;
};

// How the plan goes about its work: each idea can be switched off, so that a benchmark shows what it gains.
// The picture stays the same.
struct PlanChoices {
    enum class Force { none, all };
    enum class Values { automatic, shared, uniforms };
    enum class Lookup { automatic, selects, table };
    enum class Within { automatic, always };
    enum class Pictures { automatic, apart };
    enum class Tiles { automatic, on, off };
    enum class Arctangent { automatic, builtIn };
    enum class Pool { automatic, always };
    enum class Kernels { automatic, plain };
    Force force = Force::none;               // all: every feature in, whether the scene needs it or not
    Values values = Values::automatic;       // how materials, lights and camera reach a pixel
    Pictures pictures = Pictures::automatic; // apart: only pictures of one size share an array
    Within within = Within::automatic; // always: every solid is asked from within, though no ray gets there
    Tiles tiles = Tiles::automatic; // whether parts of the picture that show less have programs of their own
    Lookup lookup = Lookup::automatic;             // how the nearest object's surface is looked up
    Arctangent arctangent = Arctangent::automatic; // built-in: the driver's own in place of our polynomial
    Pool pool = Pool::automatic; // always: rays that split and a pool of 4, though no surface splits any
    Kernels kernels = Kernels::automatic; // plain: no object's kernel is chosen for precision
    bool operator==(const PlanChoices&) const = default;
};

// How the rasterised methods stand in for what they cannot do.
struct Raster {
    enum class ShadowFilter { nearest, percentage };
    int shadowMap_px = 1024; // a side of each shadow map; 0: nothing casts a shadow
    ShadowFilter shadowFilter = ShadowFilter::nearest;
    double shadowBias = 1.0; // times the depth that a texel spans on a surface at its angle to the light
    int interfaces = 2;      // 1 or 2: how often light is bent that is looked up in the sky through glass
};

enum class ReflectanceModel { lambert, phong, blinn, microfacet };
enum class ShadowKind { opaque, tinted, none };

struct Checker {
    glm::dvec3 colours[2]; // an even floor(u/size) + floor(v/size) takes the first
    double size = 1.0;     // metres
};

// out = emission + (1-mirror)(1-transmit) local + mirror mirrorColour reflected
//     + (1-mirror) transmit (R reflected + T refracted)
struct Material {
    std::string name;
    glm::dvec3 colour{1.0};
    std::string image; // path, resolved; "" for none; multiplies colour
    Encoding encoding = Encoding::automatic;
    std::optional<Checker> checker; // multiplies colour
    double size = 1.0;              // metres a picture spans on a plane before it repeats
    ReflectanceModel model = ReflectanceModel::lambert;
    std::optional<glm::dvec3> ambient; // reflectance for ambient light; the surface's colour where unset
    glm::dvec3 specular{0.0};
    double shininess = 32.0; // Phong (V.R)^s, Blinn (N.H)^4s
    double roughness = 0.5;  // of microfacets, whose alpha is its square
    double metalness = 0.0; // 0..1: the share that the colour has in the mirror's, and lacks in the matt part
    double mirror = 0.0;    // 0..1
    glm::dvec3 mirrorColour{1.0};
    double transmit = 0.0; // 0..1
    double ior = 1.0;
    std::optional<std::size_t> outside;     // index of the medium on the other side; air where unset
    glm::dvec3 absorption{0.0};             // per metre
    glm::dvec3 emission{0.0};               // radiance
    bool light = false;                     // its spheres also light the scene from their centres
    ShadowKind shadow = ShadowKind::opaque; // tinted by default where transmit > 0
};

// A light's colours are the radiance that a white Lambertian surface shows head-on at attenuation 1.
struct Light {
    enum class Kind { ambient, directional, point, spot };
    Kind kind = Kind::point;
    glm::dvec3 position{0.0};
    glm::dvec3 direction{0.0, -1.0, 0.0}; // along which the light travels; unit
    glm::dvec3 ambient{0.0};
    glm::dvec3 diffuse{1.0};
    glm::dvec3 specular{1.0};              // = diffuse where unset
    glm::dvec3 attenuation{1.0, 0.0, 0.0}; // constant, linear, quadratic
    double cutoff_deg = 180.0;             // half-angle of a spot's cone
    double exponent = 0.0;                 // (cos)^exponent inside the cone
};

struct Sphere {
    glm::dvec3 centre{0.0};
    double radius = 1.0;
};
struct Cylinder {
    glm::dvec3 base{0.0};
    glm::dvec3 axis{0.0, 1.0, 0.0}; // its length is the height
    double radius = 1.0;
    bool capped = false;
};
struct Plane {
    glm::dvec3 point{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};     // any length
    std::optional<double> rasterExtent_m; // side of the square about `point` that is tessellated
};
struct Disk {
    glm::dvec3 centre{0.0};
    glm::dvec3 normal{0.0, 1.0, 0.0};
    double radius = 1.0;
};
struct Rectangle {
    glm::dvec3 corner{0.0};
    glm::dvec3 edgeU{1.0, 0.0, 0.0};
    glm::dvec3 edgeV{0.0, 1.0, 0.0};
};
struct Triangle {
    glm::dvec3 a{0.0}, b{0.0}, c{0.0};
};

using Primitive = std::variant<Sphere, Cylinder, Plane, Disk, Rectangle, Triangle>;

struct Object {
    std::string name; // "" where unset
    Primitive primitive;
    std::size_t material = 0;       // index into Scene::materials
    double rotateTexture_deg = 0.0; // turns surface coordinates about the normal or the axis
    SourcePosition where;
};

// A camera, and where the moving objects are meanwhile.
struct Sight {
    Camera camera;
    std::vector<Primitive> moving; // in the order of Scene::moving
};

struct Scene {
    std::string path; // of the file
    std::string title;
    Camera camera;
    Sky sky;
    Trace trace;
    PlanChoices plan;
    Raster raster;
    Display output;                  // what a picture for the eye is shown by, where nobody asks otherwise
    std::vector<Material> materials; // in file order
    std::vector<Light> lights;       // in file order
    std::vector<Object> objects;     // in file order: the index is the object's id

    // The next two are empty where nothing is animated.
    std::vector<std::string> animated; // paths under [[animate]], in file order
    std::vector<std::size_t> moving;   // objects whose geometry is, ascending
    // First what the plan is made from, so that it is the same at every time. The numbers and colours of its
    // materials and lights are the means of their keys: 0, and a share 1, only where they are so at every
    // time. All else is as at the first key. Where latch() made it from what earlier edits held too, the
    // scene's own comes second. None where nothing is animated or latched.
    std::vector<Scene> typical;

    // Of what the plan is made from: how else its objects are looked at, in the course of its animation or
    // before the latest edits.
    std::vector<Sight> sights;
};

// What a camera sees of the scene as it is.
inline Sight sightOf(const Scene& scene, const Camera& camera)
{
    Sight sight{camera, {}};
    for (const auto id : scene.moving)
        sight.moving.push_back(scene.objects[id].primitive);
    return sight;
}

// What holds at every time, and held before the latest edits: the scene itself where nothing is animated or
// latched.
inline const Scene& typicalOf(const Scene& scene)
{
    return scene.typical.empty() ? scene : scene.typical.front();
}

// What holds at every time, whatever held before the latest edits.
inline const Scene& ownTypicalOf(const Scene& scene)
{
    return scene.typical.empty() ? scene : scene.typical.back();
}

} // namespace dioptre
