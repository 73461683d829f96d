// What a scene needs and what it does not: the table from which the shader is assembled, and that --why
// prints.
#pragma once

#include "kernel/packed_scene.h"
#include "render/data_view.h"
#include "render/kernel_choice.h"
#include "render/shader_device.h"
#include "scene/scene.h"

#include <set>
#include <string>
#include <vector>

namespace dioptre
{

// One part of the tracer, in or out, and the reason.
struct Feature {
    std::string name; // as --why prints it: "mirror"
    bool in = false;
    std::string reason;               // "material chrome", "no material transmits light"
    std::vector<std::string> defines; // HAS_… names that the shader sources ask for when it is in
};

// A picture file and how its numbers are read.
struct PictureUse {
    std::string path;
    Encoding encoding = Encoding::automatic;
    bool operator==(const PictureUse&) const = default;
};

// Along which sides a picture repeats on the objects that wear it: both on a plane, u around round shapes.
struct Repeats {
    bool u = false;
    bool v = false;
};

// A number or vector of the shader's uniforms.
struct SharedValue {
    std::string name;   // as both stages call it: "u_camera.eye.xyz"
    int components = 4; // 1 to 4
    bool isInt = false; // travels as a float
};

struct Plan {
    std::vector<Feature> features;
    std::set<std::string> defines; // of all features that are in
    SceneForm form = SceneForm::literal;
    PlanChoices::Lookup lookup = PlanChoices::Lookup::selects; // never automatic
    DataView view = DataView::none;
    RayTree tree = RayTree::single;
    int poolSlots = 3;
    int budget = 1;                     // rays a sample
    std::vector<std::size_t> materials; // those that objects or the camera use, in order
    std::vector<std::size_t>
        placedLights; // directional, point and spot lights of Scene::lights that shine, by kind
    std::vector<std::size_t> glowing;    // objects that light the scene
    std::vector<bool> seen;              // by object; those unseen stand in the light's way alone
    std::vector<bool> seenMaterials;     // by place in materials: whether a seen object is of it
    std::vector<PictureUse> pictures;    // of all objects, seen or not, each once
    std::vector<bool> sampled;           // by picture: whether a seen object wears it; as long as the next
    std::vector<Repeats> pictureRepeats; // by picture; one more than pictures where the plan forces one in
    bool padPictures = true;             // whether smaller pictures share the array of larger ones
    std::vector<SharedValue> shared;     // what comes through the vertex stage
    std::vector<bool> enteredOnly;       // by object: a solid that no ray is ever within
    std::vector<KernelForm> kernels;     // by object
    Guard guard = Guard::none;           // of compensated kernels, where there are any
    bool movesApart = false;             // whether an object moves that stands apart from a loop's table
    bool readsFine = false;              // whether the shader reads FineBlock
    bool readsMaterials = false;         // whether the shader reads any number of a material

    // Whether some object has a kernel of its own.
    bool choosesKernels() const
    {
        return defines.contains("HAS_CHOSEN_KERNELS");
    }
    const Feature& feature(const std::string& name) const; // must exist
    bool has(const std::string& name) const
    {
        return feature(name).in;
    }
};

// Whether the shader asks where a ray goes at all: an empty scene under a plain sky looks alike everywhere,
// and so does the weight lost where no ray is sent on.
bool seesDirections(const Plan& plan);

// Whether an object of this material shows a picture or a pattern, and so needs coordinates.
bool wears(const Material& material);

// Whether a material has a highlight, as far as its model shows one: microfacets mirror whatever their colour
// is.
bool canShine(const Material& material);

// The scene as its light type shows it: unlit colours are one ambient light of 1 on the surface's own colour;
// lights alone mean no ambient light and a black sky.
Scene underLightType(Scene scene);

// Rays a sample where trace.budget is unset: more where media of these materials lie within each other.
int defaultBudget(const Scene& scene, const std::vector<std::size_t>& materials);

// `scene` must have gone through underLightType() and underView(). The plan of an animated scene is the same
// at every time.
Plan makePlan(const Scene& scene, DataView view = DataView::none);

// The same for a device, where the one above is for any that keeps its promises; and for a part of the
// picture where rays meet the seen objects alone. Its materials, lights and pictures have the places that
// they have in the whole picture's plan.
Plan makePlan(const Scene& scene, DataView view, const ShaderDevice& device, std::vector<bool> seen = {});

} // namespace dioptre
