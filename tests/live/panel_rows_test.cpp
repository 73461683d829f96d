// What the panel offers: the loader takes it, and it is there when it is asked for again.
#include "base/error.h"
#include "base/file.h"
#include "live/panel_output_rows.h"
#include "live/panel_scene_rows.h"
#include "scene/load.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace dioptre::test
{
namespace
{

enum class End { low, middle, high };

std::vector<double> numbersAt(const PanelRow& row, End end)
{
    const double share = end == End::low ? 0.0 : end == End::middle ? 0.5 : 1.0;
    return fitted(row, std::vector<double>(row.numbers.size(), row.low + share * (row.high - row.low)));
}

// All rows of a scene that can be changed, the display's too.
std::vector<PanelRow> offeredRows(const Scene& scene)
{
    std::vector<PanelRow> rows = sceneRows(scene, 16);
    const std::vector<PanelRow> output = outputRows(scene.output);
    rows.insert(rows.end(), output.begin(), output.end());
    std::erase_if(rows, [](const PanelRow& row) { return !row.fixedBy.empty(); });
    return rows;
}

struct SceneText {
    std::string text;
    std::filesystem::path path;
    std::vector<std::string> overrides{}; // beneath the panel's

    Scene with(std::vector<std::string> more = {}) const
    {
        more.insert(more.begin(), overrides.begin(), overrides.end());
        return parseScene(text, path, more, 0.0, places());
    }
};

SceneText fromFile(const std::filesystem::path& path)
{
    return {readFile(path), path, ownPictures(path)};
}

SceneText written(const std::string& text)
{
    return {text, std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "text.toml"};
}

// Directions come back as unit vectors.
bool comesBack(const PanelRow& row)
{
    return !row.path.ends_with(".direction");
}

void expectTaken(const SceneText& scene, const PanelRow& row, End end)
{
    const auto numbers = numbersAt(row, end);
    const std::string change = row.path + "=" + tomlOf(row, numbers);
    SCOPED_TRACE(scene.path.string() + " --set " + change);
    Scene changed;
    ASSERT_NO_THROW(changed = scene.with({change}));
    for (const PanelRow& now : offeredRows(changed)) {
        if (now.path != row.path || now.kind != row.kind || !comesBack(row))
            continue;
        for (std::size_t i = 0; i < numbers.size(); ++i)
            EXPECT_NEAR(now.numbers[i], numbers[i], 1e-5 * std::max(1.0, std::abs(numbers[i])));
    }
}

void expectAllTaken(const SceneText& scene)
{
    const auto rows = offeredRows(scene.with());
    EXPECT_FALSE(rows.empty());
    for (const End end : {End::low, End::middle, End::high}) {
        std::vector<std::string> together;
        for (const PanelRow& row : rows) {
            expectTaken(scene, row, end);
            together.push_back(row.path + "=" + tomlOf(row, numbersAt(row, end)));
        }
        EXPECT_NO_THROW(scene.with(together)) << scene.path << " with every row at once";
    }
}

const PanelRow* find(const std::vector<PanelRow>& rows, const std::string& path)
{
    const auto row = std::ranges::find(rows, path, &PanelRow::path);
    return row == rows.end() ? nullptr : &*row;
}

const std::string glow = "[material.glow]\nemission = [3, 0, 0]\n"
                         "[material.wall]\nemission = [1, 1, 1]\n"
                         "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"glow\"\n"
                         "[[plane]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\nmaterial = \"wall\"\n";

} // namespace

TEST(PanelRows, EveryGalleryScene_EveryRowAtItsEndsAndMiddle_IsTakenByTheLoader)
{
    for (const auto& path : galleryScenes())
        expectAllTaken(fromFile(path));
}

TEST(PanelRows, ScenesOfTheTests_EveryRowAtItsEndsAndMiddle_IsTakenByTheLoader)
{
    std::size_t scenes = 0;
    const auto folder = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "tests" / "scenes";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const bool whole = readFile(entry.path()).find("\"made by the test\"") == std::string::npos;
        if (entry.path().extension() != ".toml" || !whole)
            continue;
        expectAllTaken(fromFile(entry.path()));
        ++scenes;
    }
    EXPECT_GT(scenes, 50U);
}

TEST(PanelRows, MaterialThatLights_EmissionOfZero_StaysAsItWas)
{
    const auto scene = written("[material.glow]\nemission = [3, 0, 0]\nlight = true\n"
                               "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"glow\"\n");
    const auto rows = offeredRows(scene.with());
    const PanelRow* row = find(rows, "material.glow.emission");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(fitted(*row, {0.0, 0.0, 0.0}), (std::vector<double>{3.0, 0.0, 0.0}));
    EXPECT_EQ(fitted(*row, {0.0, 0.5, 0.0}), (std::vector<double>{0.0, 0.5, 0.0}));
    expectAllTaken(scene);
}

TEST(PanelRows, MaterialThatGlows_OnSpheresAlone_MayLight)
{
    const auto scene = written(glow);
    const auto rows = offeredRows(scene.with());
    EXPECT_NE(find(rows, "material.glow.light"), nullptr);
    EXPECT_EQ(find(rows, "material.wall.light"), nullptr);
    expectAllTaken(scene);
}

TEST(PanelRows, AnimatedEmission_IsFixed_AndMayNotLight)
{
    const auto scene = written(glow + "[[animate]]\npath = \"material.glow.emission\"\ntimes = [0, 1]\n"
                                      "values = [[1, 1, 1], [0, 0, 0]]\n");
    const auto rows = sceneRows(scene.with(), 16);
    const PanelRow* row = find(rows, "material.glow.emission");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->fixedBy, "animated");
    EXPECT_EQ(find(rows, "material.glow.light"), nullptr);
    expectAllTaken(scene);
}

TEST(PanelRows, PartOfAVectorAnimated_TheWhole_IsFixed)
{
    const auto scene =
        written("[[light]]\nkind = \"point\"\nposition = [0, 3, 0]\n"
                "[[animate]]\npath = \"light.0.position.1\"\ntimes = [0, 1]\nvalues = [3, 4]\n");
    const auto rows = sceneRows(scene.with(), 16);
    const PanelRow* row = find(rows, "light.0.position");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->fixedBy, "animated");
    EXPECT_EQ(find(rows, "light.0.diffuse")->fixedBy, "");
}

TEST(PanelRows, NamesThatNoPathCanHold_AreLeftOut)
{
    const auto scene =
        written("[material.\"a.b\"]\ncolour = [1, 0, 0]\n[material.\"c=d\"]\ncolour = [1, 0, 0]\n"
                "[material.\"e f\"]\ncolour = [1, 0, 0]\n"
                "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    std::vector<std::string> sections;
    for (const PanelRow& row : sceneRows(scene.with(), 16))
        if (row.group == "Materials" && (sections.empty() || sections.back() != row.section))
            sections.push_back(row.section);
    EXPECT_EQ(sections, std::vector<std::string>{"e f"}); // "default" stands in no file either
    expectAllTaken(scene);
}

TEST(PanelRows, SceneWithoutASky_HasAColourForIt_AndNoExposure)
{
    const auto scene = written("[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n");
    const auto rows = offeredRows(scene.with());
    EXPECT_NE(find(rows, "sky.colour"), nullptr);
    EXPECT_EQ(find(rows, "sky.exposure"), nullptr);
    expectAllTaken(scene);
}

TEST(PanelRows, SpotWithoutACone_ItsCutoff_IsNeverBetween90And180)
{
    const auto scene = written("[[light]]\nkind = \"spot\"\nposition = [0, 3, 0]\ndirection = [0, -1, 0]\n"
                               "cutoff_deg = 180\n");
    const auto rows = offeredRows(scene.with());
    const PanelRow* row = find(rows, "light.0.cutoff_deg");
    ASSERT_NE(row, nullptr);
    EXPECT_EQ(row->numbers, std::vector<double>{180.0});
    EXPECT_EQ(fitted(*row, {120.0}), std::vector<double>{90.0});
    expectAllTaken(scene);
}

TEST(PanelRows, ValuesBeyondTheUsualRange_AreWithinTheRowsOwn)
{
    const auto scene = written("[material.m]\nior = 0.7\nshininess = 5000\ncolour = [2, 1, 1]\n");
    const auto rows = offeredRows(scene.with());
    for (const char* path : {"material.m.ior", "material.m.shininess", "material.m.colour"}) {
        const PanelRow* row = find(rows, path);
        ASSERT_NE(row, nullptr) << path;
        EXPECT_EQ(fitted(*row, row->numbers), row->numbers) << path;
    }
}

TEST(PanelRows, LightsOfEachKind_OfferWhatTheyTakeAlone)
{
    const auto scene = written("[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"
                               "[[light]]\nkind = \"point\"\nposition = [0, 3, 0]\n");
    const auto rows = offeredRows(scene.with());
    EXPECT_EQ(find(rows, "light.0.diffuse"), nullptr);
    EXPECT_NE(find(rows, "light.1.attenuation"), nullptr);
    EXPECT_EQ(find(rows, "light.1.cutoff_deg"), nullptr);
    EXPECT_EQ(find(rows, "light.1.direction"), nullptr);
}

TEST(PanelRows, Output_ChangedRowByRow_IsTheDisplayThatTheFileWouldGive)
{
    const auto scene = written("[output]\nexposure = 1\ncurve = \"filmic\"\n");
    const Display own = scene.with().output;
    for (const PanelRow& row : outputRows(own)) {
        const auto numbers = numbersAt(row, End::high);
        const Display changed = withOutput(own, row, numbers);
        const Display read = scene.with({row.path + "=" + tomlOf(row, numbers)}).output;
        EXPECT_EQ(changed.exposure, read.exposure) << row.path;
        EXPECT_EQ(changed.curve, read.curve) << row.path;
        EXPECT_EQ(changed.gamma, read.gamma) << row.path;
    }
}

TEST(PanelRows, DisplayAsOverrides_ReadBack_IsTheSame)
{
    const auto scene = written("[output]\nexposure = 2\ngamma = 1.8\n");
    const Display own = scene.with().output;
    for (const Display& display : {own, Display{}, Display{-1.5, ToneCurve::filmic, 2.2}}) {
        const Display read = scene.with(overridesOf(display, own)).output;
        EXPECT_EQ(read.exposure, display.exposure);
        EXPECT_EQ(read.curve, display.curve);
        EXPECT_EQ(read.gamma, display.gamma);
    }
    EXPECT_TRUE(overridesOf(own, own).empty());
}

TEST(PanelRows, Paths_OverlapBySteps_NotByLetters)
{
    EXPECT_TRUE(overlap("light.0.position", "light.0.position.1"));
    EXPECT_TRUE(overlap("light.0.position.1", "light.0.position"));
    EXPECT_TRUE(overlap("light.0.position", "light.0.position"));
    EXPECT_FALSE(overlap("light.1", "light.10"));
    EXPECT_FALSE(overlap("material.glass", "material.glass2.ior"));
}

} // namespace dioptre::test
