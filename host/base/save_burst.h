// When a file that editors are at is to be read again: not amid a burst of saves, nor long after it.
#pragma once

#include <chrono>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

namespace dioptre
{

using SaveClock = std::chrono::steady_clock;

// An editor that saves several files, or one of them by several steps, is done within this time mostly; it is
// a fifth of a picture's time at 60 a second.
inline constexpr std::chrono::milliseconds quietTime{3};
// Saves without a pause are told of all the same, within the time of one picture at 60 a second.
inline constexpr std::chrono::milliseconds longestBurst{15};
// Editors that move the old file away write the new one out to the disk before they close it, which takes
// tens of milliseconds: so long a file may be missing before that counts.
inline constexpr std::chrono::milliseconds longestAbsence{100};

class SaveBurst
{
public:
    // The file is whole, with new content.
    void saved(const std::filesystem::path& file, SaveClock::time_point now);
    // The file is gone, or there while its writer is not done.
    void vanished(const std::filesystem::path& file, SaveClock::time_point now);
    // Forgets all files but these.
    void keepOnly(const std::set<std::filesystem::path>& files);

    // When take() will have something to give; nothing while nothing is under way.
    std::optional<SaveClock::time_point> due() const;

    // The files to be read again. One that has vanished is not among them while someone writes it: the end of
    // its writing is yet to come.
    std::set<std::filesystem::path> take(SaveClock::time_point now);

private:
    struct Absence {
        SaveClock::time_point since;
        std::optional<SaveClock::time_point> first; // save of a burst that it belongs to
    };

    std::set<std::filesystem::path> saved_;
    SaveClock::time_point first_, last_; // save of the burst
    std::map<std::filesystem::path, Absence> vanished_;
};

} // namespace dioptre
