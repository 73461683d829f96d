// Edits of a scene that change numbers alone keep its shader: what a feature needed once stays in.
#pragma once

#include "scene/scene.h"

namespace dioptre
{

// Makes the plan of `scene` from what typicalOf(before) held, too: a number is 0, and a share 1, only where
// it is so in both, and constants stay relative to the origin that they had. So scenes that are each latched
// on the last one gather features, and their shader's text changes with a number only where that brings in a
// feature for the first time: an amount that leaves 0 or a share that leaves 1, a trace.depth, an eye that
// enters an opaque solid, a camera for which the origin serves no more (originServes()) or some kernel is too
// coarse, and under the breadth-first and depth-first orders a larger budget than before. The picture is the
// scene's own.
//
// Does nothing where they differ in more: in the number, names, kinds, materials, pictures or order of
// things, in a medium, the kind of sky, light type, tree order, form, plan or in what is animated. Shapes and
// places of objects may differ, and change the text. Both are as they were loaded, before underLightType().
void latch(Scene& scene, const Scene& before);

} // namespace dioptre
