// Frame times in turn: how many there are and whose, never how long they are.
#include "render/interleave.h"
#include "scene/load.h"
#include "support/rendering.h"

#include "render/renderer.h"

#include <gtest/gtest.h>

#include <cmath>

#include <algorithm>

namespace dioptre
{
namespace
{

// A bare sky in two colours: what each renderer draws can be told apart.
struct TwoSkies {
    const ContextInfo& context = test::contextFor("auto");
    ViewSettings view{8, 8, 1, test::glslFolder()};
    PreparedScene dark = prepare(parseScene("[sky]\ncolour = [0.25, 0.25, 0.25]\n", "sky.toml"), view);
    PreparedScene bright = prepare(parseScene("[sky]\ncolour = [0.75, 0.75, 0.75]\n", "sky.toml"), view);
    std::vector<std::unique_ptr<Renderer>> renderers;

    TwoSkies()
    {
        renderers.push_back(std::make_unique<Renderer>(dark, view, context));
        renderers.push_back(std::make_unique<Renderer>(bright, view, context));
    }
    std::vector<Drawing*> drawings() const
    {
        return {renderers[0].get(), renderers[1].get()};
    }
};

} // namespace

TEST(Interleave, EachRenderer_GetsATimeForEachCountedRound)
{
    TwoSkies skies;
    FrameClock clock(clockFor(skies.context));
    Rounds rounds;
    rounds.most = 9;
    const auto times_ms = timeInterleaved(skies.drawings(), clock, rounds, {});
    ASSERT_EQ(times_ms.size(), 2U);
    for (const auto& times : times_ms) {
        EXPECT_EQ(times.size(), 9U);
        EXPECT_TRUE(std::all_of(times.begin(), times.end(), [](double time_ms) { return time_ms > 0.0; }));
    }
}

TEST(Interleave, EachRenderer_DrawsItsOwnScene)
{
    TwoSkies skies;
    FrameClock clock(clockFor(skies.context));
    Rounds rounds;
    rounds.most = 1;
    timeInterleaved(skies.drawings(), clock, rounds, {});
    EXPECT_FLOAT_EQ(skies.renderers[0]->read().floats[0], 0.25F);
    EXPECT_FLOAT_EQ(skies.renderers[1]->read().floats[0], 0.75F);
}

TEST(Interleave, SpentBudget_EndsAfterTheLeastRounds)
{
    TwoSkies skies;
    FrameClock clock(clockFor(skies.context));
    Rounds rounds;
    rounds.least = 5;
    rounds.budget_ms = 0.0;
    // Five at least, and as many forwards as backwards.
    EXPECT_EQ(timeInterleaved(skies.drawings(), clock, rounds, {})[0].size(), 6U);
}

TEST(Interleave, Progress_GrowsToTheWhole)
{
    TwoSkies skies;
    FrameClock clock(clockFor(skies.context));
    Rounds rounds;
    rounds.most = 4;
    std::vector<double> told;
    timeInterleaved(skies.drawings(), clock, rounds, [&told](double share) { told.push_back(share); });
    EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
    EXPECT_GT(told.front(), 0.0);
    EXPECT_EQ(told.back(), 1.0);
}

TEST(FrameClock, OnASoftwareDriver_IsNotTheTimerQuery)
{
    ContextInfo software = test::contextFor("auto");
    software.software = true;
    EXPECT_EQ(clockFor(software), ClockKind::finish);
}

// Software drivers have timer queries too: what they say is wrong, and how they are asked is the same.
TEST(FrameClock, OfEitherKind_WaitsForTheFrame)
{
    TwoSkies skies;
    for (const ClockKind kind : {ClockKind::finish, ClockKind::timerQuery}) {
        FrameClock clock(kind);
        bool drawn = false;
        const double time_ms = clock.time_ms([&] {
            skies.renderers[1]->submit();
            drawn = true;
        });
        EXPECT_TRUE(drawn) << nameOf(kind);
        EXPECT_TRUE(std::isfinite(time_ms)) << nameOf(kind);
        EXPECT_FLOAT_EQ(skies.renderers[1]->read().floats[0], 0.75F);
        EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << nameOf(kind);
    }
}

} // namespace dioptre
