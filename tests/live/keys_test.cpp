// The table of keys.
#include "live/keys.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <utility>

namespace dioptre::test
{

TEST(Keys, EachKey_DoesOneThingAndSaysWhat)
{
    std::set<std::pair<int, bool>> seen;
    for (const auto& binding : keyBindings()) {
        EXPECT_TRUE(seen.insert({binding.key, binding.control}).second) << binding.keys;
        EXPECT_FALSE(std::string(binding.keys).empty());
        EXPECT_FALSE(std::string(binding.meaning).empty());
        EXPECT_EQ(std::string(binding.keys).starts_with("Ctrl+"), binding.control) << binding.keys;
    }
}

TEST(Keys, EveryAction_HasAKey)
{
    std::set<Action> bound;
    for (const auto& binding : keyBindings())
        bound.insert(binding.action);
    EXPECT_EQ(bound.size(), static_cast<std::size_t>(Action::discard) + 1U);
}

// Held a moment too long, a switch is not to be back where it was, nor two files to be written for one.
TEST(Keys, SwitchesAndDeeds_AreNotRepeated_StepsAre)
{
    for (const Action once :
         {Action::help, Action::panel, Action::fullscreen, Action::pause, Action::restartOnReload,
          Action::lightType, Action::screenshot, Action::writeBack, Action::discard})
        EXPECT_FALSE(isRepeated(once));
    for (const Action again : {Action::stepForward, Action::stepBack, Action::scrubForward, Action::lightUp,
                               Action::moreRays, Action::moreSamples})
        EXPECT_TRUE(isRepeated(again));
}

} // namespace dioptre::test
