// Every way in which a scene can be wrong is refused at its place, with the mend.
#include "scene/load.h"

#include <gtest/gtest.h>

#include <ostream>

namespace dioptre
{

namespace
{

struct BadScene {
    const char* name;
    const char* text;
    int line;
    int column;
    const char* fragment; // of the message
    ExitCode code = ExitCode::badInput;
};

void PrintTo(const BadScene& scene, std::ostream* out)
{
    *out << scene.text;
}

const BadScene badScenes[] = {
    // TOML itself
    {"UnclosedString", "title = \"x\n", 1, 11, "string"},
    {"KeyGivenTwice", "[trace]\nbudget = 1\nbudget = 2\n", 3, 10, "budget"},
    {"BraceInHeader", "[{a}]\n", 1, 2, "expected bare key"},           // an assertion of toml++ 3.3
    {"LetterBeyondAsciiInKey", "h\xC3\xA9 = 1\n", 1, 2, "'\xC3\xA9'"}, // undefined in toml++ 3.3
    {"MissingValue", "title =\n", 1, 8, "value"},
    // keys
    {"UnknownSection", "[camra]\n", 1, 2, "did you mean 'camera'?"},
    {"UnknownSectionLikeNone", "[[keyframes]]\npath = \"x\"\n", 1, 3, "choose from title, camera, sky"},
    {"UnknownKey", "[trace]\nfrm = \"loop\"\n", 2, 1, "[trace] has no key 'frm': did you mean 'form'?"},
    {"UnknownKeyLikeNone", "[trace]\nwibblewobble = 1\n", 2, 1, "choose from budget, depth, cut_off"},
    {"UnknownKeyOfSphere", "[[sphere]]\ncentre = [0, 0, 0]\nraduis = 1\n", 3, 1, "did you mean 'radius'?"},
    {"UnknownKeyOfMaterial", "[material.a]\nmiror = 1\n", 2, 1, "did you mean 'mirror'?"},
    {"UnknownCurve", "[output]\ncurve = \"filmc\"\n", 2, 9, "did you mean 'filmic'?"},
    {"GammaOfAnotherWord", "[output]\ngamma = \"rec709\"\n", 2, 9, "\"srgb\" or a number from 0.1 to 10"},
    {"GammaOfZero", "[output]\ngamma = 0\n", 2, 9, "\"srgb\" or a number from 0.1 to 10"},
    {"MissingRadius", "[[sphere]]\ncentre = [0, 0, 0]\n", 1, 1, "has no radius: add 'radius = ...'"},
    // types
    {"WrongType", "[camera]\nfov_y_deg = \"wide\"\n", 2, 13, "is the string \"wide\": give an angle"},
    {"TitleNotText", "title = 3\n", 1, 9, "title is the number 3: give a string"},
    {"CappedNotBoolean", "[[cylinder]]\nbase = [0, 0, 0]\naxis = [0, 1, 0]\nradius = 1\ncapped = 1\n", 5, 10,
     "give true or false"},
    {"DateForNumber", "[camera]\nfov_y_deg = 1979-05-27\n", 2, 13, "is a date or time"},
    {"SectionNotTable", "camera = 3\n", 1, 10, "[camera] is the number 3: give a table"},
    {"TableInPlaceOfArrayOfTables", "[sphere]\nradius = 1\n", 1, 1,
     "sphere is a table: give tables under [[sphere]]"},
    {"ArrayOfNumbersForSpheres", "sphere = [1]\n", 1, 11, "give tables under [[sphere]]"},
    {"MaterialNotTable", "material = 1\n", 1, 12, "[material.NAME]"},
    {"MaterialKeysWithoutName", "[material]\nmirror = 1\n", 2, 10, "[material.mirror] is the number 1"},
    {"FractionalBudget", "[trace]\nbudget = 3.5\n", 2, 10,
     "is the number 3.5: give a whole number from 1 to 4096"},
    {"ScalarForColour", "[material.a]\ncolour = 0.5\n", 2, 10, "give a colour"},
    {"ShortHexColour", "[material.a]\ncolour = \"#fff\"\n", 2, 10, "#rrggbb"},
    {"HexColourOfOtherLetters", "[material.a]\ncolour = \"#12345g\"\n", 2, 10, "#rrggbb"},
    {"TwoNumbersForVector", "[camera]\neye = [0, 1]\n", 2, 7, "eye is an array of 2: give three numbers"},
    {"FourNumbersForColour", "[material.a]\nspecular = [0, 1, 1, 1]\n", 2, 12, "is an array of 4"},
    {"TextInVector", "[camera]\neye = [0, \"a\", 1]\n", 2, 11, "eye[1] is the string \"a\""},
    {"WordUnknown", "[material.a]\nmodel = \"phon\"\n", 2, 9, "did you mean 'phong'?"},
    {"OrderUnknown", "[trace]\norder = \"random\"\n", 2, 9, "heaviest-first, breadth-first"},
    // numbers
    {"NotANumber", "[camera]\neye = [0, nan, 1]\n", 2, 11, "eye[1] is the number nan: give a finite number"},
    {"Infinite", "[trace]\ncut_off = inf\n", 2, 11, "finite"},
    {"BeyondFloat", "[camera]\neye = [0, 0, 1e300]\n", 2, 14, "32-bit float"},
    {"ZeroRadius", "[[sphere]]\ncentre = [0, 0, 0]\nradius = 0\n", 3, 10,
     "radius is the number 0: give a number above 0"},
    {"NegativeRadius", "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0, 1, 0]\nradius = -1.5\n", 4, 10, "-1.5"},
    {"MirrorAboveOne", "[material.a]\nmirror = 1.5\n", 2, 10, "from 0 to 1"},
    {"TransmitNegative", "[material.a]\ntransmit = -0.1\n", 2, 12, "from 0 to 1"},
    {"ZeroIor", "[material.a]\nior = 0\n", 2, 7, "above 0"},
    {"RoughnessOfNothing", "[material.a]\nmodel = \"microfacet\"\nroughness = 0\n", 3, 13,
     "from 0.0001 to 1"},
    {"MetalnessOver1", "[material.a]\nmodel = \"microfacet\"\nmetalness = 2\n", 3, 13, "from 0 to 1"},
    {"KernelsOfNoKind", "[plan]\nkernels = \"fine\"\n", 2, 11, "auto"},
    {"NegativeShininess", "[material.a]\nshininess = -1\n", 2, 13, "at least 0"},
    {"NegativeColour", "[material.a]\ncolour = [0, 0, -1]\n", 2, 17, "colour[2] is the number -1"},
    {"NegativeAbsorption", "[material.a]\nabsorption = [-1, 0, 0]\n", 2, 15, "absorption[0]"},
    {"ZeroSize", "[material.a]\npattern = \"checker\"\ncolours = [[1, 1, 1], [0, 0, 0]]\nsize = 0\n", 4, 8,
     "above 0"},
    {"FlatAngle", "[camera]\nfov_y_deg = 180\n", 2, 13, "above 0 and below 180"},
    {"ZeroBudget", "[trace]\nbudget = 0\n", 2, 10, "from 1 to 4096"},
    {"NegativeDepth", "[trace]\ndepth = -1\n", 2, 9, "whole number of at least 0"},
    {"NegativeCutOff", "[trace]\ncut_off = -1\n", 2, 11, "at least 0"},
    {"LightTypeThree", "[trace]\nlight_type = 3\n", 2, 14, "from 0 to 2"},
    // shapes
    {"ZeroNormal", "[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\n", 3, 10, "points nowhere"},
    {"ZeroAxis", "[[cylinder]]\nbase = [0, 0, 0]\naxis = [0, -0.0, 0]\nradius = 1\n", 3, 8, "axis is zero"},
    {"ParallelEdges",
     "[[rectangle]]\ncorner = [0, 0, 0]\nedge_u = [1e-9, 2e-9, 0]\nedge_v = [-2e-9, -4e-9, 0]\n", 4, 10,
     "parallel"},
    {"CollinearTriangle", "[[triangle]]\na = [0.1, 0.2, 0.3]\nb = [0.2, 0.4, 0.6]\nc = [0.3, 0.6, 0.9]\n", 4,
     5, "on one line"},
    {"TriangleOfOnePoint", "[[triangle]]\na = [1, 1, 1]\nb = [1, 1, 1]\nc = [1, 1, 1]\n", 4, 5, "no area"},
    {"SameNameTwice",
     "[[sphere]]\nname = \"a\"\ncentre = [0, 0, 0]\nradius = 1\n[[plane]]\nname = \"a\"\npoint = [0, 0, 0]\n"
     "normal = [0, 1, 0]\n",
     6, 8, "taken by the object at bad.toml:1"},
    // camera and sky
    {"EyeAtTarget", "[camera]\neye = [1, 2, 3]\ntarget = [1, 2, 3]\n", 3, 10, "same point"},
    {"InsideUnknown", "[camera]\ninside = \"water\"\n[material.watr]\n", 2, 10, "did you mean 'watr'?"},
    {"TwoSkies", "[sky]\ncolour = [0, 0, 0]\ngradient = [[0, 0, 0], [0, 0, 0], [0, 0, 0]]\n", 3, 12,
     "both colour and gradient: keep one"},
    {"EmptySky", "\n[sky]\nexposure = 1\n", 2, 1, "add one of colour, gradient, image"},
    {"TwoGradientColours", "[sky]\ngradient = [[0, 0, 0], [1, 1, 1]]\n", 2, 12, "an array of 3 colours"},
    {"TurnedColourSky", "[sky]\ncolour = [0, 0, 0]\nrotation_deg = 3\n", 3, 1, "no effect"},
    {"SkyPictureMissing", "[sky]\nimage = \"none.hdr\"\n", 2, 9, "no such file: none.hdr: put",
     ExitCode::inputMissing},
    // materials
    {"PictureMissing", "[material.a]\nimage = [\"no/a.png\", \"b.png\"]\n", 2, 9, "no/a.png, b.png",
     ExitCode::inputMissing},
    {"FolderAsPicture", "[material.a]\nimage = \".\"\n", 2, 9, "no such file: .", ExitCode::inputMissing},
    {"NoPictureNamed", "[material.a]\nimage = []\n", 2, 9, "a list of names"},
    {"PictureWithoutName", "[material.a]\nimage = \"\"\n", 2, 9, "empty name"},
    {"PictureIsNumber", "[material.a]\nimage = [3]\n", 2, 10, "image is the number 3"},
    {"CheckerWithoutColours", "[material.a]\npattern = \"checker\"\n", 1, 1, "has no colours"},
    {"CheckerOfOneColour", "[material.a]\npattern = \"checker\"\ncolours = [[1, 1, 1]]\n", 3, 11,
     "2 colours"},
    {"ColoursWithoutPattern", "[material.a]\ncolours = [[1, 1, 1], [0, 0, 0]]\n", 2, 1,
     "add pattern = \"checker\""},
    {"SizeOfNothing", "[material.a]\nsize = 2\n", 2, 1, "no effect"},
    {"OutsideUnknown", "[material.a]\noutside = \"b\"\n", 2, 11, "no material is called \"b\""},
    {"OutsideItself", "[material.a]\noutside = \"a\"\n", 2, 11, "a -> a"},
    {"OutsideInACircle",
     "[material.x]\noutside = \"a\"\n[material.a]\noutside = \"b\"\n[material.b]\noutside = "
     "\"c\"\n[material.c]\n"
     "outside = \"a\"\n",
     4, 11, "a -> b -> c -> a"},
    {"MaterialUnknown", "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"glas\"\n[material.glass]\n",
     4, 12, "did you mean 'glass'?"},
    {"LightWithoutEmission", "[material.a]\nlight = true\n", 2, 9, "light without emission"},
    {"LightThatIsNoSphere",
     "[material.lamp]\nemission = [1, 1, 1]\nlight = true\n\n[[plane]]\npoint = [0, 0, 0]\nnormal = [0, 1, "
     "0]\n"
     "material = \"lamp\"\n",
     5, 1, "material \"lamp\""},
    // lights
    {"LightWithoutKind", "[[light]]\nposition = [0, 0, 0]\n", 1, 1, "has no kind"},
    {"LightKindUnknown", "[[light]]\nkind = \"pint\"\n", 2, 8, "did you mean 'point'?"},
    {"AmbientLightWithoutAmbient", "[[light]]\nkind = \"ambient\"\n", 1, 1, "has no ambient"},
    {"AmbientLightWithDiffuse", "[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\ndiffuse = [1, 1, 1]\n",
     4, 1, "an ambient light takes no diffuse: it takes kind, ambient"},
    {"DirectionalWithPosition", "[[light]]\nkind = \"directional\"\nposition = [1, 1, 1]\n", 3, 1,
     "takes no position"},
    {"DirectionalWithoutDirection", "[[light]]\nkind = \"directional\"\n", 1, 1, "has no direction"},
    {"PointWithDirection", "[[light]]\nkind = \"point\"\nposition = [1, 1, 1]\ndirection = [1, 1, 1]\n", 4, 1,
     "takes no direction"},
    {"SpotWithoutCutoff", "[[light]]\nkind = \"spot\"\nposition = [1, 1, 1]\ndirection = [1, 1, 1]\n", 1, 1,
     "has no cutoff_deg"},
    {"SpotOfObtuseCutoff",
     "[[light]]\nkind = \"spot\"\nposition = [1, 1, 1]\ndirection = [1, 1, 1]\ncutoff_deg = 120\n", 5, 14,
     "0 to 90, or 180"},
    {"NegativeExponent",
     "[[light]]\nkind = \"spot\"\nposition = [1, 1, 1]\ndirection = [1, 1, 1]\ncutoff_deg = 30\nexponent = "
     "-1\n",
     6, 12, "at least 0"},
    {"ZeroDirection", "[[light]]\nkind = \"directional\"\ndirection = [0, 0, 0]\n", 3, 13, "points nowhere"},
    {"NegativeAttenuation", "[[light]]\nkind = \"point\"\nposition = [1, 1, 1]\nattenuation = [1, -1, 0]\n",
     4, 19, "attenuation[1]"},
    {"ZeroAttenuation", "[[light]]\nkind = \"point\"\nposition = [1, 1, 1]\nattenuation = [0, 0, 0]\n", 4, 15,
     "give [1, 0, 0]"}};

class Refusal : public testing::TestWithParam<BadScene>
{
};

TEST_P(Refusal, StandsAtItsPlaceAndNamesTheMend)
{
    const BadScene& bad = GetParam();
    try {
        parseScene(bad.text, "bad.toml");
        FAIL() << "was accepted";
    } catch (const Error& error) {
        const std::string message = error.what();
        const std::string place = describe(SourcePosition{"bad.toml", bad.line, bad.column}) + ": ";
        EXPECT_TRUE(message.starts_with(place)) << message << "\nis not at " << place;
        EXPECT_NE(message.find(bad.fragment), std::string::npos) << message << "\nlacks " << bad.fragment;
        EXPECT_EQ(error.code(), bad.code) << message;
    }
}

INSTANTIATE_TEST_SUITE_P(Scene, Refusal, testing::ValuesIn(badScenes),
                         [](const auto& row) { return std::string(row.param.name); });

} // namespace

} // namespace dioptre
