// How the plan is made: the rows of its table, one topic a file (plan.cpp shapes, plan_surfaces.cpp surfaces
// and rays, plan_lights.cpp lights and sky, plan_kernels.cpp the kernels' precision, plan_form.cpp the form
// that the scene takes in the shader).
#pragma once

#include "render/plan.h"

#include <functional>

namespace dioptre
{

// "5 values: a, b, c, …" of what is called a value.
std::string countedNames(const std::vector<std::string>& names, const std::string& what);

class Planner
{
public:
    // `seen` by object, or empty: all are.
    Planner(const Scene& scene, DataView view, const ShaderDevice& device, std::vector<bool> seen)
        : scene_(typicalOf(scene)), mostShared_(device.sharedVectors), guard_(device.guard)
    {
        plan_.view = view;
        plan_.seen = seen.empty() ? std::vector<bool>(scene_.objects.size(), true) : std::move(seen);
    }
    Plan make();

private:
    // A row: in with the first reason, or out with the second.
    void add(const std::string& name, bool in, const std::string& whyIn, const std::string& whyOut,
             std::vector<std::string> defines);
    bool canForce(const std::string& name, const std::vector<std::string>& defines) const;
    void addForMaterials(const std::string& name, const std::function<bool(const Material&)>& holds,
                         const std::string& whyOut, std::vector<std::string> defines);
    void addForLights(const std::string& name, const std::function<bool(const Light&)>& holds,
                      std::string whyOut, std::vector<std::string> defines);
    void addForShape(const std::string& name, const std::string& count, std::vector<std::string> defines);

    // Names of the used materials for which `holds`, or the number of lights, for a reason; "" where there is
    // none.
    std::string materialsWith(const std::function<bool(const Material&)>& holds) const;
    std::string lightsWith(const std::function<bool(const Light&)>& holds) const;

    // Whether an object is of this material: a medium around the camera has no surface. And whether one is
    // that rays meet.
    bool onObject(const Material& material) const;
    bool isSeen(const Material& material) const;
    bool seesNothing() const;

    // Whether anything but mirrored and transmitted light is seen of a surface.
    static bool hasLocal(const Material& material);

    // Whether any light falls on the scene at all; without, no surface's colour is ever asked for.
    bool anythingShines() const;

    // Whether plan.pool has rays split and wait even where no surface splits them.
    bool poolAlways() const;

    void findUsed();
    void view();
    void shapes();
    void surfaces();
    void pictures();
    // One row a kind of shape: whether any wears what `wears` holds for.
    void coordinates(const std::function<bool(const Material&)>& wears);
    void rays();
    void rayTree(bool sendsOn, bool refracts);
    void lights();
    void highlights(bool anyLight);
    void shadows(bool anyLight);
    void sky();
    void longitudes(); // after surfaces and sky, which ask for them
    void within();
    bool isAsked(std::size_t id) const;
    void kernels();
    void form();
    void values();
    // Adds rows; those that are out are so for the view's sake where `byView` holds, whatever the scene
    // holds.
    void addUnderView(void (Planner::*rows)(), bool byView);
    void gatherDefines();
    void animation();

    const Scene& scene_;   // as it is at every time
    const int mostShared_; // vec4 through the vertex stage
    const Guard guard_;    // of compensated kernels
    Plan plan_;
    std::vector<bool> onObject_, isSeen_; // by material
    bool lit_ = false;                    // some surface shows light that falls on it
};

} // namespace dioptre
