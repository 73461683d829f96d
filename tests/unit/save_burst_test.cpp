#include "base/save_burst.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

using Files = std::set<std::filesystem::path>;
using std::chrono::milliseconds;

const std::filesystem::path absent = "/nowhere/a";
const std::filesystem::path other = "/nowhere/b";

SaveClock::time_point after(milliseconds time)
{
    return SaveClock::time_point() + time;
}

} // namespace

TEST(SaveBurst, WithoutSaves_IsNeverDue)
{
    EXPECT_FALSE(SaveBurst().due());
}

TEST(SaveBurst, OneSave_IsDueOnceItIsQuiet)
{
    SaveBurst burst;
    burst.saved(absent, after(milliseconds(0)));
    EXPECT_EQ(burst.due(), after(quietTime));
    EXPECT_EQ(burst.take(after(quietTime - milliseconds(1))), Files{});
    EXPECT_EQ(burst.take(after(quietTime)), Files{absent});
    EXPECT_FALSE(burst.due());
}

TEST(SaveBurst, SavesWithoutAPause_AreDueAtTheLongest)
{
    SaveBurst burst;
    for (milliseconds now(0); now < longestBurst; ++now)
        burst.saved(now.count() % 2 == 0 ? absent : other, after(now));
    EXPECT_EQ(burst.due(), after(longestBurst));
    EXPECT_EQ(burst.take(after(longestBurst)), (Files{absent, other}));
}

TEST(SaveBurst, RemovalsAndSavesWithoutAPause_AreDueAtTheLongest)
{
    SaveBurst burst;
    for (milliseconds now(0); now < longestBurst; ++now) {
        burst.saved(absent, after(now));
        burst.vanished(absent, after(now));
        burst.vanished(absent, after(now));
    }
    burst.saved(absent, after(longestBurst));
    EXPECT_EQ(burst.due(), after(longestBurst));
}

TEST(SaveBurst, TheNextBurst_BeginsAnew)
{
    SaveBurst burst;
    burst.saved(absent, after(milliseconds(0)));
    burst.take(after(quietTime));
    burst.saved(absent, after(longestBurst));
    EXPECT_EQ(burst.due(), after(longestBurst + quietTime));
}

TEST(SaveBurst, Vanished_IsDueAfterTheGrace)
{
    SaveBurst burst;
    burst.saved(absent, after(milliseconds(0)));
    burst.vanished(absent, after(milliseconds(1)));
    EXPECT_EQ(burst.take(after(longestBurst)), Files{});
    EXPECT_EQ(burst.due(), after(milliseconds(1) + longestAbsence));
    EXPECT_EQ(burst.take(*burst.due()), Files{absent});
    EXPECT_FALSE(burst.due());
}

TEST(SaveBurst, FilesThatLeave_AreForgotten)
{
    SaveBurst burst;
    burst.saved(absent, after(milliseconds(0)));
    burst.saved(other, after(milliseconds(0)));
    burst.keepOnly({other});
    EXPECT_EQ(burst.take(after(longestBurst)), Files{other});
    burst.vanished(absent, after(milliseconds(0)));
    burst.keepOnly({other});
    EXPECT_FALSE(burst.due());
}

} // namespace dioptre
