#include "scene/track.h"

#include "scene/value_reader.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace dioptre
{

namespace
{

std::optional<double> number(const Value& value)
{
    if (const auto* real = std::get_if<double>(&value.data))
        return *real;
    if (const auto* integer = std::get_if<std::int64_t>(&value.data))
        return static_cast<double>(*integer);
    return std::nullopt;
}

// "#rrggbb" as three linear numbers: colours are mixed as light is. Other values stay as they are.
Value withoutHex(const Value& value)
{
    const auto* text = std::get_if<std::string>(&value.data);
    const std::optional<glm::dvec3> colour = text ? hexColour(*text) : std::nullopt;
    if (!colour)
        return value;
    Array channels;
    for (int i = 0; i < 3; ++i)
        channels.push_back({(*colour)[i], value.where});
    return {channels, value.where};
}

// (1 - share) a + share b of numbers, colours and arrays of them, placed where a is; a itself where they
// cannot be mixed: it is refused where it is read.
Value mixed(const Value& a, const Value& b, double share)
{
    if (share == 0.0)
        return a;
    if (const auto from = number(a), to = number(b); from && to) {
        // Rounding must not carry the mixture beyond its ends.
        const double between = *from + share * (*to - *from);
        return {std::clamp(between, std::min(*from, *to), std::max(*from, *to)), a.where};
    }
    Value result = withoutHex(a);
    const Value other = withoutHex(b);
    auto* elements = std::get_if<Array>(&result.data);
    const auto* others = std::get_if<Array>(&other.data);
    if (!elements || !others || elements->size() != others->size())
        return a;
    for (std::size_t i = 0; i < elements->size(); ++i)
        (*elements)[i] = mixed((*elements)[i], (*others)[i], share);
    return result;
}

double eased(Ease ease, double share)
{
    switch (ease) {
    case Ease::smooth:
        return share * share * (3.0 - 2.0 * share);
    case Ease::step:
        return 0.0;
    case Ease::linear:
        break;
    }
    return share;
}

// The time within a loop's first round, its end left out.
double withinLoop(const Track& track, double time_s)
{
    const double first = track.times_s.front();
    const double period = track.times_s.back() - first;
    if (time_s >= first && time_s < track.times_s.back())
        return time_s;
    const double past = std::fmod(time_s - first, period);
    return first + (past < 0.0 ? past + period : past);
}

} // namespace

Value valueAt(const Track& track, double time_s, Seam seam)
{
    const std::vector<double>& times = track.times_s;
    const bool wraps = track.loops && !(seam == Seam::last && time_s == times.back());
    const double t = wraps ? withinLoop(track, time_s) : time_s;
    if (t <= times.front())
        return track.values.front();
    if (t >= times.back())
        return wraps ? track.values.front() : track.values.back();
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(times, t) - times.begin());
    const double share = (t - times[next - 1]) / (times[next] - times[next - 1]);
    return mixed(track.values[next - 1], track.values[next], eased(track.ease, share));
}

Value meanOf(const Track& track)
{
    Value mean = track.values.front();
    for (std::size_t i = 1; i < track.values.size(); ++i)
        mean = mixed(mean, track.values[i], 1.0 / static_cast<double>(i + 1));
    return mean;
}

} // namespace dioptre
