// Which methods are shown, and how two are held against each other: what words, keys and rows make of it.
#include "live/divider.h"
#include "live/method_choice.h"
#include "live/panel_method_rows.h"
#include "live/screenshot.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dioptre::test
{
namespace
{

LiveOptions optionsOf(const std::string& method, const std::string& compare = "",
                      const std::string& view = "")
{
    LiveOptions options;
    options.input = "input";
    options.method = method;
    options.compare = compare;
    options.view = view;
    return options;
}

LiveInput scene()
{
    LiveInput input;
    input.path = "a.toml";
    return input;
}

ExitCode codeOf(const LiveOptions& options, const LiveInput& input)
{
    try {
        refuseBadMethods(options, input);
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::done;
}

const Method trace{}, flat{Shading::flat, 8}, phong{Shading::phong, 64};

// Choices that between them have every row.
std::vector<MethodChoice> choices()
{
    std::vector<MethodChoice> all;
    for (const Method& method : {trace, flat, phong, Method{Shading::gouraud, 48}})
        for (const ComparisonRow& row : comparisons)
            all.push_back({method, phong, row.comparison, 0.5, 4, true});
    return all;
}

} // namespace

TEST(MethodChoice, Words_SayWhatIsShownAndWhatStandsBesideIt)
{
    EXPECT_EQ(methodChoice(optionsOf("trace")).comparison, Comparison::off);
    const MethodChoice split = methodChoice(optionsOf("flat:8", "phong"));
    EXPECT_EQ(split.method, flat);
    EXPECT_EQ(split.other, phong);
    EXPECT_EQ(split.comparison, Comparison::split);
}

// The key that compares asks for no second method: there is always one that is not the first.
TEST(MethodChoice, WithoutACompare_TheOther_IsNotTheFirst)
{
    for (const char* method : {"trace", "flat:8", "phong"}) {
        const MethodChoice choice = methodChoice(optionsOf(method));
        EXPECT_NE(choice.method, choice.other) << method;
    }
}

TEST(MethodChoice, BadWordsPlainShadersAndViews_AreRefusedAsUsage)
{
    LiveInput shader = scene(), picture = scene();
    shader.plainShader = true;
    picture.plainShader = true;
    picture.picture = "a.png";
    EXPECT_EQ(codeOf(optionsOf("trace"), scene()), ExitCode::done);
    EXPECT_EQ(codeOf(optionsOf("phong:64", "trace"), scene()), ExitCode::done);
    EXPECT_EQ(codeOf(optionsOf("trace"), shader), ExitCode::done);
    EXPECT_EQ(codeOf(optionsOf("trace", "", "rays"), scene()), ExitCode::done);
    EXPECT_EQ(codeOf(optionsOf("phung"), scene()), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("trace", "flat:3"), scene()), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("phong"), shader), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("trace", "phong"), shader), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("trace", "phong"), picture), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("phong", "", "rays"), scene()), ExitCode::usage);
    EXPECT_EQ(codeOf(optionsOf("trace", "phong", "rays"), scene()), ExitCode::usage);
}

TEST(MethodChoice, EachMethod_IsDrawnOnce_AndTheSecondOnlyWhereItIsSeen)
{
    EXPECT_EQ(drawnMethods({trace, flat}), std::vector{trace});
    EXPECT_EQ(drawnMethods({trace, flat, Comparison::split}), (std::vector{trace, flat}));
    EXPECT_EQ(drawnMethods({trace, flat, Comparison::first}), (std::vector{trace, flat}));
    EXPECT_EQ(drawnMethods({flat, flat, Comparison::difference}), std::vector{flat});
    EXPECT_FALSE(drawsFacets({trace, flat}));
    EXPECT_TRUE(drawsFacets({trace, flat, Comparison::second}));
}

TEST(MethodChoice, CompareKey_GoesFromSplitToDifferenceToOff)
{
    MethodChoice choice;
    std::vector<Comparison> seen;
    for (int i = 0; i < 4; ++i) {
        choice = nextComparison(choice);
        seen.push_back(choice.comparison);
    }
    EXPECT_EQ(seen,
              (std::vector{Comparison::split, Comparison::difference, Comparison::off, Comparison::split}));
    choice.comparison = Comparison::second;
    EXPECT_EQ(nextComparison(choice).comparison, Comparison::split);
}

TEST(MethodChoice, FlipKey_GoesToAndFroBetweenTheTwo)
{
    const MethodChoice once = flipped({trace, flat}), twice = flipped(once);
    EXPECT_EQ(methodInFull(once), flat);
    EXPECT_EQ(methodInFull(twice), trace);
    EXPECT_EQ(methodInFull(flipped(twice)), flat);
}

TEST(MethodChoice, Scale_DoublesUpTo64AndBeginsAnew)
{
    MethodChoice choice;
    for (const int expected : {2, 4, 8, 16, 32, 64, 1}) {
        choice = nextScale(choice);
        EXPECT_EQ(choice.scale, expected);
    }
}

TEST(MethodChoice, Name_SaysWhatIsSeen)
{
    EXPECT_EQ(nameOf(MethodChoice{phong, trace}), "phong:64");
    EXPECT_EQ(nameOf(MethodChoice{trace, phong, Comparison::split}), "trace | phong:64");
    EXPECT_EQ(nameOf(MethodChoice{trace, phong, Comparison::difference, 0.5, 8}), "|trace - phong:64| x 8");
    EXPECT_EQ(nameOf(MethodChoice{trace, phong, Comparison::second}), "phong:64");
}

TEST(MethodRows, EveryWordOfEveryRow_IsWhatTheRowThenShows)
{
    for (const MethodChoice& choice : choices())
        for (const PanelRow& row : methodRows(choice)) {
            ASSERT_LT(row.numbers.front(), row.high + 1.0) << row.path;
            EXPECT_EQ(withMethod(choice, row, row.numbers).method, choice.method) << row.path;
            EXPECT_EQ(withMethod(choice, row, row.numbers).scale, choice.scale) << row.path;
            for (double place = 0.0; place <= row.high; place += 1.0) {
                const auto rows = methodRows(withMethod(choice, row, {place}));
                const auto now = std::ranges::find(rows, row.path, &PanelRow::path);
                ASSERT_NE(now, rows.end()) << row.path;
                if (row.kind == RowKind::choice)
                    EXPECT_EQ(now->words.at(static_cast<std::size_t>(now->numbers.front())).value,
                              row.words.at(static_cast<std::size_t>(place)).value)
                        << row.path;
                else
                    EXPECT_EQ(now->numbers.front(), place) << row.path;
            }
        }
}

TEST(MethodRows, WhatPlaysNoPart_HasNoRow)
{
    const auto has = [](const MethodChoice& choice, const char* path) {
        const auto rows = methodRows(choice);
        return std::ranges::find(rows, path, &PanelRow::path) != rows.end();
    };
    EXPECT_FALSE(has({trace, phong}, "method.facets"));
    EXPECT_FALSE(has({trace, phong}, "other"));
    EXPECT_FALSE(has({trace, phong}, "edges"));
    EXPECT_FALSE(has({trace, phong, Comparison::split}, "scale"));
    EXPECT_TRUE(has({trace, phong, Comparison::split}, "other.facets"));
    EXPECT_TRUE(has({trace, phong, Comparison::split}, "edges"));
    EXPECT_TRUE(has({flat, trace}, "method.facets"));
    EXPECT_TRUE(has({trace, phong, Comparison::difference}, "scale"));
}

// A count that the command line gave is among the words, and the powers of two stay around it.
TEST(MethodRows, Facets_ArePowersOfTwoAndTheOnesAskedFor)
{
    const auto rows = methodRows({Method{Shading::flat, 48}, trace});
    const auto row = std::ranges::find(rows, "method.facets", &PanelRow::path);
    ASSERT_NE(row, rows.end());
    std::vector<std::string> counts;
    for (const RowWord& word : row->words)
        counts.push_back(word.value);
    EXPECT_EQ(counts, (std::vector<std::string>{"8", "16", "32", "48", "64", "128", "256", "512"}));
}

TEST(Divider, IsTakenHoldOf_WithinSomePixels)
{
    EXPECT_EQ(dividerColumn_px(0.5, 200), 100);
    EXPECT_TRUE(isOnDivider(100.5, 0.5, 200));
    EXPECT_TRUE(isOnDivider(94.5, 0.5, 200));
    EXPECT_TRUE(isOnDivider(105.5, 0.5, 200));
    EXPECT_FALSE(isOnDivider(92.5, 0.5, 200));
    EXPECT_FALSE(isOnDivider(107.5, 0.5, 200));
}

TEST(Divider, ComesWithThePointer_AndStaysInTheWindow)
{
    EXPECT_EQ(dividerColumn_px(dividerShareAt(150.0, 200), 200), 150);
    EXPECT_EQ(dividerShareAt(-30.0, 200), 0.0);
    EXPECT_EQ(dividerShareAt(230.0, 200), 1.0);
    EXPECT_EQ(dividerShareAt(1.0, 0), 0.5);
}

TEST(MethodsInAScreenshot, OfAnotherSize_AreOneAndTheNoticeSaysSo)
{
    LiveOptions options = optionsOf("phong:64", "trace");
    LiveModel model(options);
    model.look.input.path = "a.toml";
    Loaded loaded;
    loaded.scene.emplace();
    loaded.scene->scene = std::make_shared<Scene>();
    const auto words = [&] { return renderWords(model, loaded, {}, "320x200", "out-1.png"); };
    const auto methodIn = [](const std::vector<std::string>& all) {
        const auto found = std::ranges::find(all, "--method");
        return found == all.end() ? std::string() : *(found + 1);
    };
    EXPECT_EQ(methodIn(words()), "phong:64");
    EXPECT_EQ(whatShotLacks(model.methods), ", of phong:64 alone");
    model.methods.wires = true;
    EXPECT_EQ(whatShotLacks(model.methods), ", of phong:64 alone, without edges");
    model.methods.comparison = Comparison::second;
    EXPECT_EQ(methodIn(words()), "") << "traced pictures need no word";
    EXPECT_EQ(whatShotLacks(model.methods), "");
}

} // namespace dioptre::test
