// Methods of drawing: which are shown, and how two of them are held against each other.
#include "live/divider.h"
#include "live/session.h"

#include <fmt/format.h>

namespace dioptre
{

bool Session::actOnMethods(Action action)
{
    const auto can = [&](bool so, const char* why) {
        if (!so)
            notice(why);
        return so;
    };
    if (action != Action::compare && action != Action::flip && action != Action::differenceScale &&
        action != Action::wires)
        return false;
    MethodChoice choice = model_.methods;
    if (!can(stage_.loaded()->scene.has_value(), "a plain shader is drawn by itself: methods are for scenes"))
        return true;
    if (action == Action::compare) {
        choice = nextComparison(choice);
    } else if (action == Action::flip) {
        choice = flipped(choice);
    } else if (action == Action::differenceScale) {
        if (!can(choice.comparison == Comparison::difference, "no difference is shown: B shows it"))
            return true;
        choice = nextScale(choice);
    } else {
        if (!can(drawsFacets(choice), "a traced picture has no facets: see Method in the panel"))
            return true;
        choice.wires = !choice.wires;
    }
    choose(choice);
    return true;
}

// What is drawn is asked for where it is another; how it is shown is seen at once.
void Session::choose(const MethodChoice& choice)
{
    const bool others = drawnMethods(choice) != drawnMethods(model_.methods);
    model_.methods = choice;
    if (others) {
        model_.look.view = DataView::none; // of a traced picture alone
        ask();
    }
    showChoice();
}

void Session::showChoice()
{
    try {
        stage_.compare(model_.methods);
    } catch (const Error& error) { // of the shader of edges alone
        model_.methods.wires = false;
        refuse(error);
    }
    wasDone_ = wasDone_ && stage_.isDone(); // with other edges it is drawn anew
    paints_ = 3;
    log_.say("comparison", methodDetails());
}

bool Session::isOverDivider(const glm::dvec2& at_px) const
{
    return stage_.loaded() != nullptr && stage_.loaded()->scene &&
           model_.methods.comparison == Comparison::split &&
           isOnDivider(at_px.x, model_.methods.divider, window_.size_px().x);
}

void Session::drawDividerTo(double x_px)
{
    model_.methods.divider = dividerShareAt(x_px, window_.size_px().x);
    stage_.compare(model_.methods);
    paints_ = 3;
}

// For the log. Of the methods that draw by now, the first may be another than the one that is asked for.
nlohmann::ordered_json Session::methodDetails() const
{
    if (stage_.loaded() == nullptr || !stage_.loaded()->scene)
        return nlohmann::ordered_json::object();
    const MethodChoice& choice = model_.methods;
    auto drawn = nlohmann::ordered_json::array();
    for (const MethodFacts& facts : stage_.facts().methods) {
        nlohmann::ordered_json each = {{"method", nameOf(facts.method)}, {"sample_ms", facts.sample_ms}};
        if (facts.raster)
            each.update({{"drawn", facts.raster->drawn},
                         {"culled", facts.raster->culled},
                         {"triangles", facts.raster->triangles},
                         {"shadow_maps", facts.raster->shadowMaps}});
        drawn.push_back(std::move(each));
    }
    nlohmann::ordered_json details = {{"method", nameOf(choice.method)},
                                      {"comparison", nameOf(choice.comparison)}};
    if (choice.comparison != Comparison::off)
        details["compare"] = nameOf(choice.other);
    if (choice.comparison == Comparison::split)
        details["divider_px"] = dividerColumn_px(choice.divider, window_.size_px().x);
    if (choice.comparison == Comparison::difference)
        details["scale"] = choice.scale;
    details["edges"] = choice.wires;
    details["methods"] = std::move(drawn);
    return details;
}

} // namespace dioptre
