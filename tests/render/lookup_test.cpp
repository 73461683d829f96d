// Chains of selects: one value for each item, by whichever form has fewer steps.
#include "assembled.h"
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

TEST(KindOf, NamesEachKindByItsConstant)
{
    const auto shader =
        assembled("[camera]\neye = [0, 0, 5]\n[[light]]\nkind = \"point\"\nposition = [0, 9, 0]\n"
                  "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
                  "[[triangle]]\na = [0, 0, 0]\nb = [1, 0, 0]\nc = [0, 1, 0]\n");
    EXPECT_NE(shader.fragment.find("return object < 1 ? KIND_SPHERE :\n        KIND_TRIANGLE;"),
              std::string::npos)
        << shader.fragment;
}
