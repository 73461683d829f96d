// [[animate]]: values of a scene over time.
#include "scene/load.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>

namespace dioptre
{

namespace
{

// A ball whose radius is animated; `rest` ends the table.
std::string radius(const std::string& values, const std::string& rest = "")
{
    return "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 9\n"
           "[[animate]]\npath = \"ball.radius\"\ntimes = [1, 2, 4]\nvalues = " +
           values + "\n" + rest;
}

double radiusAt(const std::string& text, double time_s)
{
    return std::get<Sphere>(parseScene(text, "a.toml", {}, time_s).objects[0].primitive).radius;
}

// The scene's text with one animation after it.
Scene with(const std::string& scene, const std::string& path, const std::string& values, double time_s,
           const std::vector<std::string>& overrides = {})
{
    return parseScene(scene + "[[animate]]\npath = \"" + path + "\"\ntimes = [0, 4]\nvalues = " + values +
                          "\n",
                      "a.toml", overrides, time_s);
}

const std::string ball = "[[sphere]]\nname = \"ball\"\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"m\"\n";
const std::string sceneOfAll = "[camera]\neye = [0, 0, 5]\n[sky]\ncolour = [1, 1, 1]\n[material.m]\n"
                               "[[light]]\nkind = \"spot\"\nposition = [0, 5, 0]\ndirection = [0, -1, 0]\n"
                               "cutoff_deg = 30\n" +
                               ball;

TEST(Animation, Linear_GoesEvenlyFromKeyToKey)
{
    const std::string text = radius("[10, 20, 40]");
    for (const auto& [time_s, expected] :
         {std::pair{1.0, 10.0}, {1.25, 12.5}, {2.0, 20.0}, {3.0, 30.0}, {4.0, 40.0}})
        EXPECT_DOUBLE_EQ(radiusAt(text, time_s), expected) << time_s;
}

TEST(Animation, Smooth_RestsAtTheKeysAndIsHalfWayInTheMiddle)
{
    const std::string text = radius("[10, 20, 40]", "ease = \"smooth\"\n");
    // 3 s^2 - 2 s^3 is 5/32 at 1/4, 1/2 at 1/2, 27/32 at 3/4.
    EXPECT_DOUBLE_EQ(radiusAt(text, 1.25), 10.0 + 10.0 * 5.0 / 32.0);
    EXPECT_DOUBLE_EQ(radiusAt(text, 1.5), 15.0);
    EXPECT_DOUBLE_EQ(radiusAt(text, 1.75), 10.0 + 10.0 * 27.0 / 32.0);
    EXPECT_NEAR(radiusAt(text, 2.0 + 1e-4), 20.0, 1e-6);
    EXPECT_DOUBLE_EQ(radiusAt(text, 2.0), 20.0);
}

TEST(Animation, Step_HoldsEachKeyUpToTheNext)
{
    const std::string text = radius("[10, 20, 40]", "ease = \"step\"\n");
    EXPECT_EQ(radiusAt(text, 1.999), 10.0);
    EXPECT_EQ(radiusAt(text, 2.0), 20.0);
    EXPECT_EQ(radiusAt(text, 3.999), 20.0);
    EXPECT_EQ(radiusAt(text, 4.0), 40.0);
}

TEST(Animation, BeforeTheFirstAndAfterTheLastKey_TheEndsHold)
{
    const std::string text = radius("[10, 20, 40]");
    EXPECT_EQ(radiusAt(text, -1e6), 10.0);
    EXPECT_EQ(radiusAt(text, 0.0), 10.0);
    EXPECT_EQ(radiusAt(text, 1e6), 40.0);
}

TEST(Animation, Loop_RepeatsBothWaysWithThePeriodOfItsKeys)
{
    const std::string text = radius("[10, 20, 40]", "loop = true\n");
    for (const double round_s : {-300.0, -3.0, 0.0, 3.0, 3000.0}) {
        EXPECT_NEAR(radiusAt(text, 1.5 + round_s), 15.0, 1e-9) << round_s;
        EXPECT_NEAR(radiusAt(text, 3.0 + round_s), 30.0, 1e-9) << round_s;
        EXPECT_EQ(radiusAt(text, 4.0 + round_s), 10.0) << "the first key's turn, " << round_s;
    }
    EXPECT_EQ(radiusAt(radius("[10, 20, 40]", "ease = \"step\"\nloop = true\n"), 4.0), 10.0);
}

TEST(Animation, EveryKindOfPath_ReachesItsValue)
{
    EXPECT_EQ(with(sceneOfAll, "camera.eye", "[[0, 0, 4], [0, 8, 8]]", 1.0).camera.eye,
              glm::dvec3(0.0, 2.0, 5.0));
    EXPECT_EQ(with(sceneOfAll, "camera.fov_y_deg", "[20, 40]", 2.0).camera.fovY_deg, 30.0);
    EXPECT_EQ(with(sceneOfAll, "sky.colour", "[[0, 0, 0], [4, 8, 0]]", 1.0).sky.colour,
              glm::dvec3(1.0, 2.0, 0.0));
    EXPECT_EQ(with(sceneOfAll, "sky.exposure", "[0, 4]", 1.0).sky.exposure, 1.0);
    EXPECT_EQ(with(sceneOfAll, "material.m.ior", "[1, 2]", 1.0).materials[0].ior, 1.25);
    EXPECT_EQ(with(sceneOfAll, "light.0.direction", "[[0, -1, 0], [1, 0, 0]]", 4.0).lights[0].direction,
              glm::dvec3(1.0, 0.0, 0.0));
    EXPECT_EQ(with(sceneOfAll, "light.0.cutoff_deg", "[20, 60]", 1.0).lights[0].cutoff_deg, 30.0);
    EXPECT_EQ(with(sceneOfAll, "sphere.0.rotate_texture_deg", "[0, 360]", 1.0).objects[0].rotateTexture_deg,
              90.0);
    const Scene scene = with(sceneOfAll, "ball.centre.1", "[0, 4]", 3.0);
    EXPECT_EQ(std::get<Sphere>(scene.objects[0].primitive).centre, glm::dvec3(0.0, 3.0, 0.0));
}

TEST(Animation, SectionThatTheFileLacks_IsCreated)
{
    EXPECT_EQ(with("", "camera.eye", "[[0, 0, 4], [0, 0, 8]]", 1.0).camera.eye, glm::dvec3(0.0, 0.0, 5.0));
    EXPECT_EQ(with("", "sky.colour", "[[0, 0, 0], [4, 4, 4]]", 1.0).sky.colour, glm::dvec3(1.0));
}

TEST(Animation, Colours_MixAsLight)
{
    // "#ffffff" is 1 in linear light, and half of it 0.5, where half of its sRGB bytes would be 0.21.
    const auto colourAt = [](double time_s) {
        return with(sceneOfAll, "material.m.colour", "[\"#000000\", \"#ffffff\"]", time_s)
            .materials[0]
            .colour;
    };
    EXPECT_EQ(colourAt(2.0), glm::dvec3(0.5));
    EXPECT_EQ(colourAt(4.0), glm::dvec3(1.0));
    EXPECT_EQ(with(sceneOfAll, "material.m.colour", "[\"#ff0000\", [0, 1, 0]]", 1.0).materials[0].colour,
              glm::dvec3(0.75, 0.25, 0.0));
    const std::string sky = "[sky]\ngradient = [[0, 0, 0], [1, 1, 1], [0, 0, 1]]\n";
    EXPECT_EQ(with(sky, "sky.gradient.1", "[[1, 1, 1], \"#ff0000\"]", 2.0).sky.gradient[1],
              glm::dvec3(1.0, 0.5, 0.5));
    EXPECT_EQ(with(sky, "sky.gradient",
                   "[[\"#ffffff\", [1, 1, 1], [0, 0, 1]], [[0, 0, 0], [1, 0, 1], [4, 0, 1]]]", 1.0)
                  .sky.gradient[2],
              glm::dvec3(1.0, 0.0, 1.0));
}

TEST(Animation, Scene_NamesWhatChangesAndWhatMoves)
{
    const Scene scene = parseScene(
        "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\n[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n"
        "[[disk]]\nname = \"d\"\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = 1\n[material.default]\n"
        "[[animate]]\npath = \"d.radius\"\ntimes = [0, 1]\nvalues = [1, 2]\n"
        "[[animate]]\npath = \"plane.0.point\"\ntimes = [0, 1]\nvalues = [[0, 0, 0], [0, 1, 0]]\n"
        "[[animate]]\npath = \"disk.0.centre\"\ntimes = [0, 1]\nvalues = [[0, 0, 0], [0, 1, 0]]\n"
        "[[animate]]\npath = \"material.default.mirror\"\ntimes = [0, 1]\nvalues = [0, 1]\n",
        "a.toml");
    EXPECT_EQ(scene.animated, (std::vector<std::string>{"d.radius", "plane.0.point", "disk.0.centre",
                                                        "material.default.mirror"}));
    EXPECT_EQ(scene.moving, (std::vector<std::size_t>{0, 2}));
    EXPECT_TRUE(parseScene("", "a.toml").typical.empty());
}

TEST(Animation, TypicalScene_IsTheSameAtEveryTimeAndZeroOnlyWhereAllKeysAre)
{
    for (const double time_s : {-1.0, 0.0, 1.0, 9.0}) {
        const Scene scene = with(sceneOfAll, "material.m.mirror", "[0, 1]", time_s);
        EXPECT_EQ(typicalOf(scene).materials[0].mirror, 0.5);
        EXPECT_EQ(typicalOf(with(sceneOfAll, "material.m.mirror", "[1, 1]", time_s)).materials[0].mirror,
                  1.0);
        EXPECT_EQ(typicalOf(with(sceneOfAll, "light.0.ambient", "[[0, 0, 0], \"#ff0000\"]", time_s))
                      .lights[0]
                      .ambient,
                  glm::dvec3(0.5, 0.0, 0.0));
        EXPECT_EQ(typicalOf(with(sceneOfAll, "camera.eye", "[[0, 0, 4], [0, 8, 8]]", time_s)).camera.eye,
                  glm::dvec3(0.0, 0.0, 4.0));
    }
}

TEST(Animation, WhereNoKeyIsAtZeroSeconds_NothingIsAskedOfThatMoment)
{
    // Half-way, at 0 s, the eye is at the target: no view at all.
    const std::string text =
        "[camera]\neye = [0, 1, 5]\ntarget = [0, 1, 0]\n[[animate]]\npath = \"camera.eye\"\n"
        "times = [-1, 1]\nvalues = [[0, 1, -5], [0, 1, 5]]\n";
    EXPECT_EQ(parseScene(text, "a.toml", {}, 1.0).camera.eye, glm::dvec3(0.0, 1.0, 5.0));
    EXPECT_THROW(parseScene(text, "a.toml", {}, 0.0), Error);
}

TEST(Animation, AlmostOppositeDirections_HaveNoMeanAndNeedNone)
{
    const Scene scene = with(sceneOfAll, "light.0.direction", "[[0, -1, 0], [0, 1, 0]]", 1.0);
    EXPECT_EQ(scene.lights[0].direction, glm::dvec3(0.0, -1.0, 0.0));
}

TEST(Animation, Overrides_ChangeItsOwnValuesOrTakeItOut)
{
    const std::string values = "[[0, 0, 4], [0, 8, 8]]";
    EXPECT_EQ(with(sceneOfAll, "camera.eye", values, 1.0, {"animate.0.times=[0, 2]"}).camera.eye,
              glm::dvec3(0.0, 4.0, 6.0));
    EXPECT_EQ(with(sceneOfAll, "camera.eye", values, 1.0, {"animate=[]"}).camera.eye,
              glm::dvec3(0.0, 0.0, 5.0));
}

struct BadAnimation {
    const char* name;
    std::string text; // after sceneOfAll
    int line;         // counted from the first of `text`
    int column;
    const char* fragment; // of the message
};

void PrintTo(const BadAnimation& bad, std::ostream* out)
{
    *out << bad.text;
}

std::string animate(const std::string& path, const std::string& times, const std::string& values)
{
    return "[[animate]]\npath = \"" + path + "\"\ntimes = " + times + "\nvalues = " + values + "\n";
}

const BadAnimation badAnimations[] = {
    // the table
    {"NoArrayOfTables", "[animate]\npath = \"ball.radius\"\n", 1, 1, "give tables under [[animate]]"},
    {"NoPath", "[[animate]]\ntimes = [0, 1]\nvalues = [1, 2]\n", 1, 1, "has no path"},
    {"NoTimes", "[[animate]]\npath = \"ball.radius\"\nvalues = [1, 2]\n", 1, 1, "has no times"},
    {"UnknownKey", animate("ball.radius", "[0, 1]", "[1, 2]") + "lop = true\n", 5, 1, "did you mean 'loop'?"},
    {"UnknownEase", animate("ball.radius", "[0, 1]", "[1, 2]") + "ease = \"smoth\"\n", 5, 8,
     "did you mean 'smooth'?"},
    {"LoopIsNumber", animate("ball.radius", "[0, 1]", "[1, 2]") + "loop = 1\n", 5, 8, "true or false"},
    // paths
    {"UnknownObject", animate("bal.radius", "[0, 1]", "[1, 2]"), 2, 8, "did you mean 'ball'?"},
    {"UnknownSection", animate("camra.eye", "[0, 1]", "[1, 2]"), 2, 8, "did you mean 'camera'?"},
    {"UnknownMaterial", animate("material.n.ior", "[0, 1]", "[1, 2]"), 2, 8, "there is no 'n': it has m"},
    {"UnknownObjectsKey", animate("ball.raduis", "[0, 1]", "[1, 2]"), 2, 8, "did you mean 'radius'?"},
    {"UnknownMaterialsKey", animate("material.m.miror", "[0, 1]", "[1, 2]"), 2, 8, "did you mean 'mirror'?"},
    {"NoSuchLight", animate("light.1.diffuse", "[0, 1]", "[[1, 1, 1], [1, 1, 1]]"), 2, 8,
     "count from 0 to 0"},
    {"NoSuchElement", animate("ball.centre.3", "[0, 1]", "[1, 2]"), 2, 8, "count from 0 to 2"},
    {"PartOfANumber", animate("ball.radius.x", "[0, 1]", "[1, 2]"), 2, 8, "leads into the number 1"},
    {"WholeObject", animate("sphere.0", "[0, 1]", "[1, 2]"), 2, 8, "add a key, such as sphere.0.centre"},
    {"WholeCamera", animate("camera", "[0, 1]", "[1, 2]"), 2, 8, "add a key, such as camera.eye"},
    {"Title", animate("title", "[0, 1]", "[1, 2]"), 2, 8, "nothing of title changes with time"},
    {"Budget", animate("trace.budget", "[0, 1]", "[1, 2]"), 2, 8, "nothing of trace changes with time"},
    {"Itself", animate("animate.0.times", "[0, 1]", "[1, 2]"), 2, 8, "nothing of animate changes"},
    {"Model", animate("material.m.model", "[0, 1]", "[\"phong\", \"blinn\"]"), 4, 11,
     "give a number, a vector or a colour"},
    {"ModelOfNumbers", animate("material.m.model", "[0, 1]", "[1, 2]"), 2, 8,
     "a material has no number, vector or colour called 'model': choose from colour"},
    {"Kind", animate("light.0.kind", "[0, 1]", "[1, 2]"), 2, 8, "a light has no number"},
    {"NameOfAnObject", animate("ball.name", "[0, 1]", "[1, 2]"), 2, 8, "an object has no number"},
    {"CameraInside", animate("camera.inside", "[0, 1]", "[1, 2]"), 2, 8,
     "choose from eye, target, fov_y_deg"},
    {"KeyOfAnotherKindOfLight",
     "[[light]]\nkind = \"point\"\nposition = [0, 0, 0]\n" +
         animate("light.1.cutoff_deg", "[0, 1]", "[1, 2]"),
     5, 8, "a point light takes no cutoff_deg"},
    {"OnePathTwice",
     animate("ball.radius", "[0, 1]", "[1, 2]") + animate("sphere.0.radius", "[0, 1]", "[1, 2]"), 6, 8,
     "animated already, at bad.toml:17:8"},
    {"APathAndItsPart",
     animate("ball.centre", "[0, 1]", "[[0, 0, 0], [1, 1, 1]]") +
         animate("ball.centre.1", "[0, 1]", "[1, 2]"),
     6, 8, "keep one of them"},
    // times
    {"TimesNoArray", animate("ball.radius", "3", "[1, 2]"), 3, 9, "give at least two times"},
    {"OneTime", animate("ball.radius", "[0]", "[1]"), 3, 9, "give at least two times"},
    {"TimesGoBack", animate("ball.radius", "[0, 2, 1]", "[1, 2, 3]"), 3, 16,
     "times[2] is the number 1: give a time after the one before it"},
    {"TimesStandStill", animate("ball.radius", "[0, 0]", "[1, 2]"), 3, 13, "after the one before"},
    {"TimeIsInfinite", animate("ball.radius", "[0, inf]", "[1, 2]"), 3, 13, "finite"},
    {"TimeIsText", animate("ball.radius", "[0, \"1\"]", "[1, 2]"), 3, 13, "times[1] is the string"},
    // values
    {"FewerValuesThanTimes", animate("ball.radius", "[0, 1, 2]", "[1, 2]"), 4, 10,
     "values is an array of 2: give 3 values, one for each time"},
    {"NumberForVector", animate("ball.centre", "[0, 1]", "[[0, 0, 0], 1]"), 4, 22, "give three numbers"},
    {"VectorForNumber", animate("ball.radius", "[0, 1]", "[1, [2, 2, 2]]"), 4, 14, "give a number above 0"},
    {"ShortVector", animate("ball.centre", "[0, 1]", "[[0, 0, 0], [1, 1]]"), 4, 22, "is an array of 2"},
    {"TextInVector", animate("ball.centre", "[0, 1]", "[[0, 0, 0], [1, 1, true]]"), 4, 29,
     "values[1][2] is true"},
    {"HexForVector", animate("ball.centre", "[0, 1]", "[[0, 0, 0], \"#ff0000\"]"), 4, 22,
     "give three numbers"},
    {"ZeroRadiusAtOneKey", animate("ball.radius", "[0, 1, 2]", "[1, 0, 2]"), 4, 14,
     "radius is the number 0: give a number above 0 (at 1 s)"},
    {"MirrorAboveOneAtTheLastKey", animate("material.m.mirror", "[0, 1]", "[0, 1.5]"), 4, 14, "from 0 to 1"},
    {"BadLastKeyOfALoop", animate("ball.radius", "[0, 1]", "[1, -1]") + "loop = true\n", 4, 14, "above 0"},
    {"BadKeyOfTheSecond",
     animate("ball.centre.0", "[0, 1, 2]", "[0, 1, 2]") + animate("ball.radius", "[0, 1.9]", "[1, -5]"), 8,
     14, "radius is the number -5"},
    {"NaN", animate("ball.radius", "[0, 1]", "[1, nan]"), 4, 14, "finite number"},
    {"EyeMeetsTarget", animate("camera.eye", "[0, 1]", "[[0, 0, 5], [0, 0, 0]]"), 4, 22, "same point"},
};

class AnimationRefusal : public testing::TestWithParam<BadAnimation>
{
};

TEST_P(AnimationRefusal, StandsAtItsPlaceAndNamesTheMend)
{
    const BadAnimation& bad = GetParam();
    const int before = static_cast<int>(std::ranges::count(sceneOfAll, '\n'));
    try {
        parseScene(sceneOfAll + bad.text, "bad.toml");
        FAIL() << "was accepted";
    } catch (const Error& error) {
        const std::string message = error.what();
        const std::string place = describe(SourcePosition{"bad.toml", before + bad.line, bad.column}) + ": ";
        EXPECT_TRUE(message.starts_with(place)) << message << "\nis not at " << place;
        EXPECT_NE(message.find(bad.fragment), std::string::npos) << message << "\nlacks " << bad.fragment;
        EXPECT_EQ(error.code(), ExitCode::badInput) << message;
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, AnimationRefusal, testing::ValuesIn(badAnimations),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(Animation, MixtureThatIsNoDirection_NamesItsTime)
{
    try {
        with(sceneOfAll, "light.0.direction", "[[0, -1, 0], [0, 1, 0]]", 2.0);
        FAIL() << "was accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("points nowhere"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("(at 2 s)"), std::string::npos) << error.what();
        ASSERT_EQ(error.complaints().size(), 1U);
        EXPECT_TRUE(std::string(error.what()).starts_with(describe(error.complaints()[0].where) + ": "));
        EXPECT_GT(error.complaints()[0].where.column, 0);
    }
}

TEST(Animation, OverrideOfWhatIsAnimated_WouldHaveNoEffect)
{
    for (const char* text : {"ball.radius=3", "sphere.0.radius=3"}) {
        try {
            with(sceneOfAll, "ball.radius", "[1, 2]", 0.0, {text});
            FAIL() << "was accepted";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::usage);
            const std::string message = error.what();
            EXPECT_TRUE(message.starts_with("--set " + std::string(text) + ": it is animated at a.toml:"))
                << message;
        }
    }
}

} // namespace

} // namespace dioptre
