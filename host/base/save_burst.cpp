#include "base/save_burst.h"

#include "base/open_writer.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace dioptre
{

void SaveBurst::saved(const std::filesystem::path& file, SaveClock::time_point now)
{
    // Nor may one who removes and writes it without a pause put off the telling for ever.
    const auto absence = vanished_.extract(file);
    const auto first = absence ? absence.mapped().first.value_or(now) : now;
    first_ = saved_.empty() ? first : std::min(first_, first);
    last_ = now;
    saved_.insert(file);
}

void SaveBurst::vanished(const std::filesystem::path& file, SaveClock::time_point now)
{
    Absence& absence = vanished_[file];
    absence.since = now;
    if (saved_.erase(file) > 0)
        absence.first = first_;
}

void SaveBurst::keepOnly(const std::set<std::filesystem::path>& files)
{
    std::erase_if(saved_, [&](const auto& file) { return !files.contains(file); });
    std::erase_if(vanished_, [&](const auto& one) { return !files.contains(one.first); });
}

std::optional<SaveClock::time_point> SaveBurst::due() const
{
    std::optional<SaveClock::time_point> due;
    if (!saved_.empty())
        due = std::min(last_ + quietTime, first_ + longestBurst);
    for (const auto& [file, absence] : vanished_)
        due = std::min(due.value_or(SaveClock::time_point::max()), absence.since + longestAbsence);
    return due;
}

std::set<std::filesystem::path> SaveBurst::take(SaveClock::time_point now)
{
    std::set<std::filesystem::path> ready;
    if (!saved_.empty() && now >= std::min(last_ + quietTime, first_ + longestBurst))
        ready = std::exchange(saved_, {});
    std::erase_if(vanished_, [&](const auto& one) {
        if (now < one.second.since + longestAbsence)
            return false;
        std::error_code fault;
        if (!std::filesystem::exists(one.first, fault) || !hasWriter(one.first))
            ready.insert(one.first);
        return true;
    });
    return ready;
}

} // namespace dioptre
