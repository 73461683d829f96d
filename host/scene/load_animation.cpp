#include "scene/primitive.h"
#include "scene/sections.h"
#include "scene/table_reader.h"
#include "scene/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{

namespace
{

const std::vector<std::string> lightColours{"ambient", "diffuse", "specular"};

// A section of the scene whose numbers, vectors and colours may change.
struct Animatable {
    std::string_view name; // in messages
    std::size_t keyStep;   // which step of a path is the key
    std::vector<std::string> keys;
};

Animatable animatableIn(const std::string& section)
{
    if (section == "camera")
        return {"[camera]", 1, {"eye", "target", "fov_y_deg"}};
    if (section == "sky")
        return {"[sky]", 1, {"colour", "gradient", "rotation_deg", "exposure"}};
    if (section == "material")
        return {"a material",
                2,
                {"colour", "colours", "size", "ambient", "specular", "shininess", "roughness", "metalness",
                 "mirror", "mirror_colour", "transmit", "ior", "absorption", "emission"}};
    if (section == "light") {
        Animatable light{"a light", 2, {"position", "direction", "attenuation", "cutoff_deg", "exponent"}};
        light.keys.insert(light.keys.end(), lightColours.begin(), lightColours.end());
        return light;
    }
    for (const PrimitiveKind& kind : primitiveKinds())
        if (kind.key == section) {
            Animatable object{"an object", 2, kind.required};
            object.keys.emplace_back("rotate_texture_deg");
            return object;
        }
    return {};
}

// Structure stays: names, pictures, kinds and how the picture is traced.
void checkAnimatable(const Track& track)
{
    const Animatable section = animatableIn(track.steps.front());
    if (section.keys.empty())
        fail(ExitCode::badInput, track.where,
             fmt::format("nothing of {} changes with time", track.steps.front()),
             "animate the camera, the sky, a material, a light or an object");
    if (track.steps.size() <= section.keyStep)
        fail(ExitCode::badInput, track.where, fmt::format("'{}' is more than one value", track.path),
             fmt::format("add a key, such as {}.{}", track.path, section.keys.front()));
    const std::string& key = track.steps[section.keyStep];
    if (std::ranges::find(section.keys, key) == section.keys.end())
        refuseWord(track.where,
                   fmt::format("{} has no number, vector or colour called '{}'", section.name, key), key,
                   section.keys);
}

std::vector<double> readTimes(const Value& value)
{
    std::vector<double> times;
    for (const Value& element : arrayFrom(value, "times", "at least two times, in seconds")) {
        const std::string name = fmt::format("times[{}]", times.size());
        times.push_back(numberFrom(element, name, anyNumber));
        if (times.size() > 1 && times.back() <= times[times.size() - 2])
            refuse(element, name, "a time after the one before it");
    }
    if (times.size() < 2)
        refuse(value, "times", "at least two times, in seconds");
    return times;
}

// A number, a colour, or an array of them.
void checkMixable(const Value& value, const std::string& name)
{
    if (const auto* array = std::get_if<Array>(&value.data)) {
        for (std::size_t i = 0; i < array->size(); ++i)
            checkMixable((*array)[i], fmt::format("{}[{}]", name, i));
        return;
    }
    const auto* text = std::get_if<std::string>(&value.data);
    if (!text || !hexColour(*text))
        numberFrom(value, name, {-unbounded, unbounded, false, "a number, a vector or a colour"});
}

Array readValues(const Value& value, std::size_t count)
{
    const Array& values =
        arrayFrom(value, "values", count, fmt::format("{} values, one for each time", count));
    for (std::size_t i = 0; i < values.size(); ++i)
        checkMixable(values[i], fmt::format("values[{}]", i));
    return values;
}

Track readTrack(Value& document, const Value& value)
{
    const TableReader reader(value, "[[animate]]", {"path", "times", "values", "ease", "loop"});
    reader.require({"path", "times", "values"});
    Track track;
    reader.text("path", track.path);
    track.where = reader.where("path");
    track.times_s = readTimes(*reader.find("times"));
    track.values = readValues(*reader.find("values"), track.times_s.size());
    reader.choice<Ease>("ease", track.ease,
                        {{"linear", Ease::linear}, {"smooth", Ease::smooth}, {"step", Ease::step}});
    reader.flag("loop", track.loops);
    track.steps = resolve(document, {track.path, track.where, ExitCode::badInput});
    checkAnimatable(track);
    return track;
}

} // namespace

std::vector<Track> takeTracks(Value& document)
{
    std::vector<Track> tracks;
    // A copy: a path may create a section, which moves the tables.
    const Value before = document;
    for (const Value* value : tablesUnder(std::get<Table>(before.data), "animate")) {
        Track track = readTrack(document, *value);
        for (const Track& other : tracks)
            if (overlap(track.steps, other.steps))
                fail(ExitCode::badInput, track.where,
                     fmt::format("'{}' is animated already, at {}", track.path, describe(other.where)),
                     "keep one of them");
        tracks.push_back(std::move(track));
    }
    std::erase_if(std::get<Table>(document.data).entries,
                  [](const Entry& entry) { return entry.key == "animate"; });
    return tracks;
}

bool mixesFreely(const Track& track)
{
    const std::string& section = track.steps[0];
    return section == "material" ||
           (section == "light" && std::ranges::find(lightColours, track.steps[2]) != lightColours.end());
}

} // namespace dioptre
