// A value of a scene's document over time, as [[animate]] gives it.
#pragma once

#include "scene/document_path.h"

#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

// The way from one key to the next: evenly, with rest at both ends (3 s^2 - 2 s^3), or in one leap at the
// end.
enum class Ease { linear, smooth, step };

// The last key of a loop falls on the first of its next round: which of them shows at that instant. A scene
// shows the first; the last is asked for where keys are checked.
enum class Seam { first, last };

struct Track {
    std::string path; // as written
    Steps steps;
    SourcePosition where;        // of the path
    std::vector<double> times_s; // rising
    Array values;                // one for each time, as written
    Ease ease = Ease::linear;
    bool loops = false; // else the first and the last value hold before and after
};

// Takes the tables under [[animate]] out of the document, in file order. Sections that their paths lead to
// are created where the file lacks them. Throws badInput for a path that leads nowhere, to what is no number,
// vector or colour, or to what another animates; and for times and values that do not go together.
std::vector<Track> takeTracks(Value& document);

Value valueAt(const Track& track, double time_s, Seam seam = Seam::first);

// The mean of a track's keys. Of amounts of at least 0 it is 0, and of shares it is 1, only where all are.
Value meanOf(const Track& track);

// Whether any mixture of good values is one: of a material's numbers and colours, and of a light's colours. A
// mixture of directions may point nowhere.
bool mixesFreely(const Track& track);

} // namespace dioptre
