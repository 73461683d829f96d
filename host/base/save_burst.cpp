#include "base/save_burst.h"

#include <algorithm>
#include <system_error>
#include <utility>

namespace dioptre
{

void SaveBurst::saved(const std::filesystem::path& file, SaveClock::time_point now)
{
    if (saved_.empty())
        first_ = now;
    last_ = now;
    saved_.insert(file);
    vanished_.erase(file);
}

void SaveBurst::vanished(const std::filesystem::path& file, SaveClock::time_point now)
{
    saved_.erase(file);
    vanished_.insert_or_assign(file, now);
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
    for (const auto& [file, since] : vanished_)
        due = std::min(due.value_or(SaveClock::time_point::max()), since + longestAbsence);
    return due;
}

std::set<std::filesystem::path> SaveBurst::take(SaveClock::time_point now)
{
    std::set<std::filesystem::path> ready;
    if (!saved_.empty() && now >= std::min(last_ + quietTime, first_ + longestBurst))
        ready = std::exchange(saved_, {});
    std::erase_if(vanished_, [&](const auto& one) {
        if (now < one.second + longestAbsence)
            return false;
        std::error_code fault;
        if (!std::filesystem::exists(one.first, fault))
            ready.insert(one.first);
        return true;
    });
    return ready;
}

} // namespace dioptre
