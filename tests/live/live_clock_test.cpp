// Time as it is played. Nothing here waits, or asks how long anything took.
#include "live/live_clock.h"

#include <gtest/gtest.h>

namespace dioptre::test
{

TEST(LiveClock, Paused_StandsStill)
{
    const LiveClock clock(3.5, true);
    EXPECT_TRUE(clock.isPaused());
    EXPECT_EQ(clock.time_s(), 3.5);
    EXPECT_EQ(clock.time_s(), 3.5);
}

TEST(LiveClock, Running_BeginsAtItsStartAndNeverGoesBack)
{
    const LiveClock clock(3.5, false);
    double last_s = 3.5;
    for (int i = 0; i < 1000; ++i) {
        const double time_s = clock.time_s();
        ASSERT_GE(time_s, last_s);
        last_s = time_s;
    }
}

TEST(LiveClock, PauseAndGoOn_LosesNoTimeAndSkipsNone)
{
    LiveClock clock(0.0, false);
    clock.jumpTo(10.0);
    clock.pause(true);
    const double held_s = clock.time_s();
    EXPECT_GE(held_s, 10.0);
    EXPECT_EQ(clock.time_s(), held_s);
    clock.pause(true);
    EXPECT_EQ(clock.time_s(), held_s);
    clock.pause(false);
    EXPECT_FALSE(clock.isPaused());
    EXPECT_GE(clock.time_s(), held_s);
}

TEST(LiveClock, JumpsWhilePaused_AreExactAndKeepThePause)
{
    LiveClock clock(1.0, true);
    clock.jumpBy(0.25);
    EXPECT_EQ(clock.time_s(), 1.25);
    clock.jumpBy(-2.0);
    EXPECT_EQ(clock.time_s(), -0.75);
    clock.jumpTo(100.0);
    EXPECT_EQ(clock.time_s(), 100.0);
    EXPECT_TRUE(clock.isPaused());
}

TEST(LiveClock, Restart_IsTheMomentThatItBeganAt_PausedOrNot)
{
    LiveClock paused(2.0, true);
    paused.jumpTo(50.0);
    paused.restart();
    EXPECT_EQ(paused.time_s(), 2.0);
    LiveClock running(2.0, false);
    running.jumpTo(1e6);
    running.restart();
    EXPECT_GE(running.time_s(), 2.0);
    EXPECT_LT(running.time_s(), 1e6);
    EXPECT_FALSE(running.isPaused());
}

} // namespace dioptre::test
