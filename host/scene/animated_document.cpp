#include "scene/animated_document.h"

#include "scene/sections.h"
#include "scene/sights_along.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

namespace dioptre
{

namespace
{

// The scene with every track at the value that `valueOf` gives; `time_s` is for messages.
Scene sceneWith(const AnimatedDocument& animation, double time_s,
                const std::function<Value(const Track&)>& valueOf)
{
    Value document = animation.document;
    for (const Track& track : animation.tracks)
        setAt(document, track.steps, valueOf(track), track.where);
    try {
        return readScene(document, animation.path, animation.places);
    } catch (const Error& error) {
        failAgain(error, fmt::format("{} (at {} s)", error.what(), time_s));
    }
}

// Each key while the other tracks are at a key of theirs, never at a mixture.
void checkKeysAlone(const AnimatedDocument& animation)
{
    for (const Track& checked : animation.tracks)
        for (std::size_t i = 0; i < checked.values.size(); ++i)
            sceneWith(animation, checked.times_s[i], [&](const Track& track) {
                return &track == &checked ? track.values[i] : track.values.front();
            });
}

std::set<double> keyTimes(const std::vector<Track>& tracks)
{
    std::set<double> times;
    for (const Track& track : tracks)
        times.insert(track.times_s.begin(), track.times_s.end());
    return times;
}

// The object that a track leads into, if it does; the document's tables are known by their places.
std::optional<std::size_t> movedBy(const Track& track, const Table& document, const Scene& scene)
{
    if (std::ranges::find(objectKinds(), track.steps[0]) == objectKinds().end())
        return std::nullopt;
    const auto& tables = std::get<Array>(find(document, track.steps[0])->data);
    const SourcePosition& where = tables[std::stoul(track.steps[1])].where;
    const auto object = std::ranges::find_if(scene.objects, [&](const Object& candidate) {
        return candidate.where.line == where.line && candidate.where.column == where.column;
    });
    return static_cast<std::size_t>(object - scene.objects.begin());
}

void nameChanges(Scene& scene, const AnimatedDocument& animation)
{
    std::set<std::size_t> moving;
    for (const Track& track : animation.tracks) {
        scene.animated.push_back(track.path);
        if (const auto object = movedBy(track, std::get<Table>(animation.document.data), scene))
            moving.insert(*object);
    }
    scene.moving = {moving.begin(), moving.end()};
}

} // namespace

void visitKeys(AnimatedDocument& animation)
{
    std::vector<Sight> keys;
    for (const double time_s : keyTimes(animation.tracks)) {
        try {
            Scene scene = sceneWith(animation, time_s,
                                    [&](const Track& track) { return valueAt(track, time_s, Seam::last); });
            nameChanges(scene, animation);
            keys.push_back(sightOf(scene, scene.camera));
        } catch (const Error&) {
            // A mixture may have failed of which a key is the cause: that is the place to name.
            checkKeysAlone(animation);
            throw;
        }
    }
    animation.sights = sightsAlong(keys);
}

Scene sceneAt(const AnimatedDocument& animation, double time_s)
{
    Scene scene = sceneWith(animation, time_s, [&](const Track& track) { return valueAt(track, time_s); });
    nameChanges(scene, animation);
    // A moment that visitKeys() has found good; at 0 s there may be no key.
    const double first_s = *keyTimes(animation.tracks).begin();
    scene.typical.push_back(sceneWith(animation, first_s, [&](const Track& track) {
        return mixesFreely(track) ? meanOf(track) : valueAt(track, first_s, Seam::last);
    }));
    nameChanges(scene.typical.front(), animation);
    scene.typical.front().sights = animation.sights;
    return scene;
}

} // namespace dioptre
