// Chains of selects: one value for each item, by whichever form has fewer steps.
#include "render/lookup.h"

#include <gtest/gtest.h>

using namespace dioptre;

namespace
{

// The values by name; "" does not matter.
std::string selected(const std::vector<std::string>& values)
{
    return selectText(
        "i", values.size(),
        [&](std::size_t i) { return values[i].empty() ? std::nullopt : std::optional(values[i]); }, "rest");
}

} // namespace

TEST(SelectText, NeighboursThatShareAValue_AreRanges)
{
    EXPECT_EQ(selected({"a", "a", "b", "b", "b", "c"}), "i < 2 ? a :\n        i < 5 ? b :\n        c");
}

TEST(SelectText, AValueThatStandsOut_IsAskedForByName)
{
    // Ranges would take two steps.
    EXPECT_EQ(selected({"a", "a", "b", "a", "a"}), "i == 2 ? b :\n        a");
}

TEST(SelectText, WhereBothTakeAsManySteps_RangesAreTaken)
{
    EXPECT_EQ(selected({"a", "b"}), "i < 1 ? a :\n        b");
}

TEST(SelectText, AnOnlyValue_NeedsNoSelect)
{
    EXPECT_EQ(selected({"a"}), "a");
    EXPECT_EQ(selected({"a", "a", "a"}), "a");
    EXPECT_EQ(selected({"", "", "a", ""}), "a");
}

TEST(SelectText, AValueThatDoesNotMatter_TakesNoStep)
{
    EXPECT_EQ(selected({"", "a", "", "a", "b", ""}), "i < 4 ? a :\n        b");
    EXPECT_EQ(selected({"a", "", "b", "", "a", ""}), "i == 2 ? b :\n        a");
}

TEST(SelectText, WhereNoneMatters_IsTheRest)
{
    EXPECT_EQ(selected({"", ""}), "rest");
    EXPECT_EQ(selected({}), "rest");
}
