// A scene's document with the tracks that change it: the scene at any time, and what holds at all times.
#pragma once

#include "base/search_places.h"
#include "scene/scene.h"
#include "scene/track.h"

#include <filesystem>
#include <vector>

namespace dioptre
{

struct AnimatedDocument {
    Value document; // as the file and the overrides have it
    std::vector<Track> tracks;
    std::filesystem::path path; // of the file
    SearchPlaces places;        // of its pictures
    std::vector<Sight> sights;  // at the keys and on the way from each to the next; filled in by visitKeys()
};

// Every key must give a good scene at its time, together with what the others are at by then. Throws badInput
// at the value that does not.
void visitKeys(AnimatedDocument& animation);

// The scene at a time, with what of it changes and the typical scene. Throws badInput where a mixture of good
// keys is no good, such as two opposite directions half-way.
Scene sceneAt(const AnimatedDocument& animation, double time_s);

} // namespace dioptre
