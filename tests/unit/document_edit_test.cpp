// Values written into a scene's text: what changes, what stays, and what is refused.
#include "scene/document_edit.h"

#include "base/file.h"
#include "scene/override.h"
#include "scene/value_text.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <ostream>
#include <random>

namespace dioptre
{

namespace
{

struct Edit {
    const char* name;
    std::string before;
    std::vector<std::string> overrides;
    std::string after;
};

void PrintTo(const Edit& edit, std::ostream* out)
{
    *out << edit.before;
}

const std::string twoBalls = "[[sphere]]\nname = \"ball\"\ncentre = [0.0, 1.0, 0.0]\nradius = 1.0\n\n"
                             "[[sphere]]\ncentre = [\n    0.0,  # x\n   10.0,  # y\n    0.0\n]\nradius = 2\n";

const Edit edits[] = {
    {"Number",
     "[camera]\nfov_y_deg = 42.0   # wide\n",
     {"camera.fov_y_deg=30.5"},
     "[camera]\nfov_y_deg = 30.5   # wide\n"},
    {"WholeNumberForAFloat_StaysAFloat",
     "[camera]\nfov_y_deg = 42.0\n",
     {"camera.fov_y_deg=30"},
     "[camera]\nfov_y_deg = 30.0\n"},
    {"WholeNumber", "[trace]\nbudget = 16\n", {"trace.budget=8"}, "[trace]\nbudget = 8\n"},
    {"FloatForAWholeNumber",
     "[camera]\nfov_y_deg = 42\n",
     {"camera.fov_y_deg=1.0"},
     "[camera]\nfov_y_deg = 1.0\n"},
    {"ValueThatIsThereAlready_KeepsItsSpelling",
     "[camera]\nfov_y_deg = 4.20e1\n",
     {"camera.fov_y_deg=42"},
     "[camera]\nfov_y_deg = 4.20e1\n"},
    {"ShortestExactNumber",
     "[camera]\nfov_y_deg = 1.0\n",
     {"camera.fov_y_deg=0.10000000000000001"},
     "[camera]\nfov_y_deg = 0.1\n"},
    {"MinusZero",
     "[camera]\neye = [0.0, 1.0, 2.0]\n",
     {"camera.eye.0=-0.0"},
     "[camera]\neye = [-0.0, 1.0, 2.0]\n"},
    {"WordAndFlag",
     "[trace]\nform = \"loop\" # x\nnormalise = true\n",
     {"trace.form=constants", "trace.normalise=false"},
     "[trace]\nform = \"constants\" # x\nnormalise = false\n"},
    {"StringThatNeedsEscapes",
     "title = 'a'\n",
     {"title=\"q\\\"\\\\\\n\xC3\xBC\""},
     "title = \"q\\\"\\\\\\u000A\xC3\xBC\"\n"},
    {"BehindOtherLetters",
     "title = \"\xC3\xBC\xE2\x82\xAC\" # \xC3\xBC\ncamera = { fov_y_deg = 1.0, "
     "\"\xC3\xBC\" = 2, eye = [ 0.0,1.0 ,2.0 ] }\n",
     {"camera.eye=[0, 5, 2]", "title=\xC3\xA4"},
     "title = \"\xC3\xA4\" # \xC3\xBC\ncamera = { fov_y_deg = 1.0, \"\xC3\xBC\" = 2, eye = [ 0.0,5.0 ,2.0 ] "
     "}\n"},
    {"VectorOfAnObjectByName",
     twoBalls,
     {"ball.centre=[0.25, 1, 0]"},
     "[[sphere]]\nname = \"ball\"\ncentre = [0.25, 1.0, 0.0]\nradius = 1.0\n\n"
     "[[sphere]]\ncentre = [\n    0.0,  # x\n   10.0,  # y\n    0.0\n]\nradius = 2\n"},
    {"ElementOfAnArrayOverSeveralLines",
     twoBalls,
     {"sphere.1.centre.1=-1.5", "ball.centre.2=7"},
     "[[sphere]]\nname = \"ball\"\ncentre = [0.0, 1.0, 7.0]\nradius = 1.0\n\n"
     "[[sphere]]\ncentre = [\n    0.0,  # x\n   -1.5,  # y\n    0.0\n]\nradius = 2\n"},
    {"ArrayOfAnotherLength",
     "[sky]\ngradient = [[1.0, 1.0, 1.0],\n  [0.0, 0.0, 0.0]] # two\n",
     {"sky.gradient=[[1, 2, 3]]"},
     "[sky]\ngradient = [[1.0, 2.0, 3.0]] # two\n"},
    {"ColourForAWord",
     "[material.a]\ncolour = \"#ffffff\"\n",
     {"material.a.colour=[1, 0.5, 0]"},
     "[material.a]\ncolour = [1, 0.5, 0]\n"},
    {"ByteOrderMarkAndCarriageReturns",
     "\xEF\xBB\xBF"
     "title = \"a\"\r\n\r\n[camera]\r\nfov_y_deg = 4.0\r\n",
     {"title=b", "camera.fov_y_deg=5", "camera.inside=water", "trace.budget=4"},
     "\xEF\xBB\xBF"
     "title = \"b\"\r\n\r\n[camera]\r\nfov_y_deg = 5.0\r\ninside = \"water\"\r\n\r\n"
     "[trace]\r\nbudget = 4\r\n"},
    {"InlineTable",
     "camera = {eye=[0,0,0]} # here\n",
     {"camera.eye.1=2", "camera.fov_y_deg=30.0"},
     "camera = {eye=[0,2,0], fov_y_deg = 30.0} # here\n"},
    {"EmptyInlineTable", "trace = {}\n", {"trace.budget=4"}, "trace = {budget = 4}\n"},
    {"DottedKeys",
     "  camera.eye = [0, 0, 5] # eye\n  camera.target = [0, 0, 0]\ntitle = \"a\"\n",
     {"camera.eye.0=1", "camera.fov_y_deg=30.0"},
     "  camera.eye = [1, 0, 5] # eye\n  camera.target = [0, 0, 0]\n  camera.fov_y_deg = 30.0\ntitle = "
     "\"a\"\n"},
    {"DottedKeysInAnInlineTable",
     "material = { a.colour = [1, 1, 1], b = {} }\n",
     {"material.a.ior=1.5", "material.b.ior=1.25"},
     "material = { a.colour = [1, 1, 1], a.ior = 1.5, b = {ior = 1.25} }\n"},
    {"DottedKeysUnderAHeader",
     "[material]\na.ior = 1.5\na.mirror = 1\n\nb.ior = 1.0\n",
     {"material.a.ior=2", "material.a.transmit=0.5"},
     "[material]\na.ior = 2.0\na.mirror = 1\na.transmit = 0.5\n\nb.ior = 1.0\n"},
    {"ArrayOfInlineTables",
     "sphere = [{centre=[0, 0, 0], radius=1}, {centre=[1, 0, 0], radius = 2.0}]\n",
     {"sphere.1.radius=3", "sphere.0.material=\"a\""},
     "sphere = [{centre=[0, 0, 0], radius=1, material = \"a\"}, {centre=[1, 0, 0], radius = 3.0}]\n"},
    {"MaterialAndLight",
     "[material.glass]\nior = 1.5\n[[light]]\nkind = \"ambient\"\n[[light]]\ndiffuse = [1, 1, 1]\n",
     {"material.glass.ior=1.75", "light.1.diffuse.2=0"},
     "[material.glass]\nior = 1.75\n[[light]]\nkind = \"ambient\"\n[[light]]\ndiffuse = [1, 1, 0]\n"},
    {"NewKey_StandsBehindTheLastOfItsTable",
     "[camera]\n  eye = [0,\n    1, 2] # far\n\n# The light.\n[[light]]\nkind = \"ambient\"\n",
     {"camera.fov_y_deg=30"},
     "[camera]\n  eye = [0,\n    1, 2] # far\n  fov_y_deg = 30\n\n# The light.\n[[light]]\nkind = "
     "\"ambient\"\n"},
    {"NewKeyOfAnEmptyTable",
     "  [trace] # none yet\n# after\n",
     {"trace.budget=4"},
     "  [trace] # none yet\n  budget = 4\n# after\n"},
    {"NewKeyBeforeATableWithinTheTable",
     "[[light]]\nkind = \"point\"\n[material]\n[material.a]\nior = 2.0\n",
     {"light.0.exponent=2", "material.a.mirror=0.5"},
     "[[light]]\nkind = \"point\"\nexponent = 2\n[material]\n[material.a]\nior = 2.0\nmirror = 0.5\n"},
    {"NewKeyBeforeAHeaderThatFollowsThoseWithinIt",
     "title = \"a\"\n[material.a]\nior = 2.0\n[material]\n",
     {"animate=[]", "material.a.mirror=1"},
     "title = \"a\"\nanimate = []\n[material.a]\nior = 2.0\nmirror = 1\n[material]\n"},
    {"NewKeyOfTheWholeScene",
     "# A scene.\n\n[camera]\n",
     {"title=\"a\""},
     "title = \"a\"\n# A scene.\n\n[camera]\n"},
    {"NewKeyBehindAFileWithoutALastLineBreak",
     "[camera]\neye = [0, 0, 1]",
     {"camera.fov_y_deg=30"},
     "[camera]\neye = [0, 0, 1]\nfov_y_deg = 30"},
    {"NewTable",
     "title = \"a\"\n# end",
     {"trace.form=loop", "trace.budget=4"},
     "title = \"a\"\n# end\n\n[trace]\nform = \"loop\"\nbudget = 4\n"},
    {"NewTableOfAnEmptyFile", "", {"trace.form=loop"}, "[trace]\nform = \"loop\"\n"},
    {"OtherKindOfSky",
     "[sky]\nimage = \"sky.exr\" # dusk\nrotation_deg = 3\nexposure = -1.0\n",
     {"sky.colour=[0, 0, 1]"},
     "[sky]\n# dusk\nexposure = -1.0\ncolour = [0, 0, 1]\n"},
    {"OtherKindOfSkyInAnInlineTable",
     "sky = { image = \"sky.exr\", exposure = -1.0, mirror_u = true }\n",
     {"sky.colour=[0, 0, 1]"},
     "sky = { exposure = -1.0, colour = [0, 0, 1] }\n"},
    {"OtherKindOfSkyOfDottedKeys",
     "sky.gradient = [[0, 0, 0],\n [1, 1, 1]]\n[camera]\n",
     {"sky.image=\"a.png\""},
     "sky.image = \"a.png\"\n[camera]\n"},
    {"TimesOfAnAnimation",
     "[[animate]]\npath = \"camera.eye\"\ntimes = [0.0, 1.0]\n",
     {"animate.0.times.1=2.5"},
     "[[animate]]\npath = \"camera.eye\"\ntimes = [0.0, 2.5]\n"},
    {"QuotedKey",
     "[material.\"a b\"]\nior = 1.0\n",
     {"material.a b.ior=2", "material.a b.mirror=1"},
     "[material.\"a b\"]\nior = 2.0\nmirror = 1\n"},
    {"NameWithDots",
     "[[sphere]]\nname = \"a.b\"\nradius = 1.0\n",
     {"a.b.radius=2"},
     "[[sphere]]\nname = \"a.b\"\nradius = 2.0\n"},
    {"NothingToChange", "# x", {}, "# x"},
};

class DocumentEdit : public testing::TestWithParam<Edit>
{
};

TEST_P(DocumentEdit, ChangesThatAndNothingElse)
{
    const Edit& edit = GetParam();
    EXPECT_EQ(withValues(edit.before, "a.toml", edit.overrides), edit.after);
}

INSTANTIATE_TEST_SUITE_P(Layouts, DocumentEdit, testing::ValuesIn(edits),
                         [](const auto& row) { return std::string(row.param.name); });

struct BadEdit {
    const char* text;
    const char* override;
    ExitCode code;
    const char* fragment; // of the message
};

TEST(DocumentEdit, WhatCannotBeWritten_IsRefused)
{
    for (const BadEdit& bad :
         {BadEdit{"[[sphere]]\nradius = 1\n", "sphere=[]", ExitCode::badInput, "by hand"},
          {"[[sphere]]\nradius = 1\n", "sphere.0=1", ExitCode::badInput, "by hand"},
          {"sky.colour = [1, 1, 1]\n", "sky=1", ExitCode::badInput, "by hand"},
          {"title = \"a\"\n", "title=1979-05-27", ExitCode::badInput, "date"},
          {"title = \"a\"\n", "title={}", ExitCode::usage, "table"},
          {"title = \"a\"\n", "title", ExitCode::usage, "path=value"},
          {"[camera]\n", "camra.eye=1", ExitCode::usage, "camera"},
          {"title = \n", "title=1", ExitCode::badInput, "a.toml:1"}}) {
        try {
            withValues(bad.text, "a.toml", {bad.override});
            ADD_FAILURE() << bad.override << " was written";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), bad.code) << error.what();
            EXPECT_NE(std::string(error.what()).find(bad.fragment), std::string::npos) << error.what();
        }
    }
}

// The paths of all numbers of a document.
void collectNumbers(const Value& value, const std::string& path, std::vector<std::string>& paths)
{
    const auto stepTo = [&path](const std::string& step) { return path.empty() ? step : path + "." + step; };
    if (const auto* table = std::get_if<Table>(&value.data))
        for (const Entry& entry : table->entries)
            collectNumbers(entry.value, stepTo(entry.key), paths);
    else if (const auto* array = std::get_if<Array>(&value.data))
        for (std::size_t i = 0; i < array->size(); ++i)
            collectNumbers((*array)[i], stepTo(std::to_string(i)), paths);
    else if (std::holds_alternative<double>(value.data) || std::holds_alternative<std::int64_t>(value.data))
        paths.push_back(path);
}

// Whether only characters of one number of `before` differ.
bool differInOneNumber(const std::string& before, const std::string& after)
{
    const auto [first, other] = std::ranges::mismatch(before, after);
    const auto head = static_cast<std::size_t>(first - before.begin());
    std::size_t tail = 0;
    while (tail < std::min(before.size(), after.size()) - head &&
           before[before.size() - 1 - tail] == after[after.size() - 1 - tail])
        ++tail;
    const auto isNumber = [](const std::string& text) {
        return text.find_first_not_of("-+.0123456789e") == std::string::npos;
    };
    return isNumber(before.substr(head, before.size() - tail - head)) &&
           isNumber(after.substr(head, after.size() - tail - head));
}

TEST(DocumentEdit, AnyNumberOfTheGallery_ChangesAlone)
{
    std::mt19937 random(7);
    std::size_t scenes = 0;
    for (const auto& file : std::filesystem::directory_iterator(DIOPTRE_SOURCE_DIR "/glsl/scenes")) {
        if (file.path().extension() != ".toml")
            continue;
        ++scenes;
        const std::string text = readFile(file.path());
        const Value document = parseDocument(text, "a.toml");
        std::vector<std::string> paths;
        collectNumbers(document, "", paths);
        ASSERT_FALSE(paths.empty()) << file.path();
        for (int i = 0; i < 40; ++i) {
            const double number =
                std::ldexp(static_cast<double>(random()), static_cast<int>(random() % 60) - 60);
            const std::string change = fmt::format("{}={}", paths[random() % paths.size()], number);
            const std::string after = withValues(text, "a.toml", {change});
            Value wanted = document;
            applyOverrides(wanted, {change});
            EXPECT_TRUE(saySame(parseDocument(after, "a.toml"), wanted)) << file.path() << " " << change;
            EXPECT_TRUE(differInOneNumber(text, after)) << file.path() << " " << change;
            EXPECT_NE(text, after) << file.path() << " " << change;
        }
    }
    EXPECT_GT(scenes, 10U);
}

} // namespace

} // namespace dioptre
