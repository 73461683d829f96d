// Bad input ends with a message that names the place and the mend, the right exit code, and no picture.
#include "support/process.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using dioptre::test::run;

namespace
{

struct Case {
    std::string name;
    std::string setUp;   // shell commands, in an empty folder
    std::string command; // what the user types
    int code;
    std::vector<std::string> says; // on standard error
};

void PrintTo(const Case& refused, std::ostream* stream)
{
    *stream << refused.command;
}

// A scene file of the given text.
std::string scene(const std::string& text)
{
    return "printf '" + text + "' >bad.toml";
}

// p.frag in Shadertoy's manner.
const std::string plainShader =
    "printf 'void mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(1.0);\n}\n' >p.frag";
const std::string small = " --size 16x9 --spp 1 -o a.png";
const std::string renderBad = "dioptre render bad.toml" + small;

// A copy of the sources that the program reads, to be edited.
const std::string ownSources =
    "mkdir -p own/host/command; cp -r \"$SOURCES/glsl\" own/glsl; ln -s \"$SOURCES/textures\" own/textures; "
    "export DIOPTRE_GLSL=$PWD/own/glsl; ";

const std::vector<Case> cases = {
    {"NoCommand", "", "dioptre", 2, {"subcommand", "--help"}},
    {"UnknownCommand", "", "dioptre rendr still_life", 2, {"rendr"}},
    {"UnknownOption", "", "dioptre render still_life --sise 16x9 -o a.png", 2, {"--sise", "--help"}},
    {"UnknownOptionOfList", "", "dioptre list --yaml", 2, {"--yaml", "dioptre list --help"}},
    {"SizeOfNonsense", "", "dioptre render still_life --size 16by9 -o a.png", 2, {"16by9", "WIDTHxHEIGHT"}},
    {"SizeOfZero", "", "dioptre render still_life --size 0x9 -o a.png", 2, {"0x9"}},
    {"ChannelOfAScene",
     "",
     "dioptre render spheres --channel0 a.png -o b.png",
     2,
     {"--channel0", "plain shaders"}},
    {"MouseOfNonsense", plainShader, "dioptre render p.frag --mouse 3 -o a.png", 2, {"--mouse 3", "X,Y"}},
    {"ChannelThatIsMissing", plainShader, "dioptre render p.frag --channel1 no.png -o a.png", 66, {"no.png"}},
    {"ChannelFilterOfNonsense",
     plainShader,
     "dioptre render p.frag --channel1 'no.png?filter=soft' -o a.png",
     2,
     {"--channel1", "filter=nearest"}},
    {"CubeOfTwoFaces", plainShader, "dioptre render p.frag --channel1 a.png,b.png -o a.png", 2, {"six"}},
    {"CubeOfOblongFaces",
     plainShader + "; dioptre render p.frag --size 4x2 -o f.png 2>/dev/null",
     "dioptre render p.frag --channel1 f.png,f.png,f.png,f.png,f.png,f.png -o a.png",
     65,
     {"f.png", "squares", "4x2"}},
    {"CrossOfNoFaces",
     plainShader + "; dioptre render p.frag --size 4x2 -o f.png 2>/dev/null",
     "dioptre render p.frag --channel1 'f.png?cube' -o a.png",
     65,
     {"f.png", "4 by 3"}},
    {"SetThatDoesNotFit",
     "printf 'uniform int n;\nvoid main()\n{\n    gl_FragColor = vec4(float(n));\n}\n' >p.frag",
     "dioptre render p.frag --set n=1.5 -o a.png",
     2,
     {"--set n=1.5", "int"}},
    {"SetWithoutAValue", plainShader, "dioptre render p.frag --set n -o a.png", 2, {"--set n", "NAME=VALUE"}},
    {"ShaderThatDoesNotLink",
     "printf 'float g();\nvoid mainImage(out vec4 o, in vec2 p)\n{\n    o = vec4(g());\n}\n' >p.frag",
     "dioptre render p.frag -o a.png",
     65,
     {"p.frag: ", "g"}},
    {"ShaderThatIncludesItself",
     "echo '#include \"p.frag\"' >p.frag",
     "dioptre render p.frag -o a.png",
     65,
     {"p.frag:1", "includes itself"}},
    {"UniformOfATypeThatItsNumberIsNot",
     "printf 'uniform int u_time;\nvoid main()\n{\n    gl_FragColor = vec4(float(u_time));\n}\n' >p.frag",
     "dioptre render p.frag --time 2.5 -o a.png",
     65,
     {"p.frag", "u_time", "2.5", "float"}},
    {"SamplerThatNothingFeeds",
     "printf 'uniform sampler2D s;\nvoid main()\n{\n    gl_FragColor = texture(s, vec2(0.5));\n}\n' >p.frag",
     "dioptre render p.frag -o a.png",
     65,
     {"p.frag", "sampler s", "iChannel0"}},
    {"ShaderWithoutMain",
     "printf 'float x;\n' >p.frag",
     "dioptre render p.frag -o a.png",
     65,
     {"p.frag", "mainImage"}},
    {"StandardOutputFull", "", "dioptre list >/dev/full", 73, {"standard output"}},
    {"StandardOutputClosed", "", "dioptre list --json >&-", 73, {"standard output"}},
    {"SizeThatOverflows",
     "",
     "dioptre render still_life --size 4294967306x10 -o a.png",
     2,
     {"4294967306x10"}},
    {"SizeWithBlanks", "", "dioptre render still_life --size ' 16x 9' -o a.png", 2, {"WIDTHxHEIGHT"}},
    {"ShaderInPlaceOfThePicture",
     "",
     "dioptre render still_life --size 16x9 --shader ./a.png -o a.png",
     2,
     {"a.png", "name two files"}},
    {"SizeBeyondAll", "", "dioptre render still_life --size 999999x9 -o a.png", 2, {"999999x9", "131072"}},
    {"NoSamples", "", "dioptre render still_life --spp 0 -o a.png", 2, {"--spp"}},
    {"TimeOfNonsense", "", "dioptre render orrery --time soon" + small, 2, {"--time"}},
    {"TimeThatIsNoNumber",
     "",
     "dioptre render orrery --time nan" + small,
     2,
     {"--time", "number of seconds"}},
    {"UnknownBackend", "", "dioptre render still_life --backend vulkan -o a.png", 2, {"vulkan", "osmesa"}},
    {"UnknownPictureKind",
     "",
     "dioptre render still_life --size 16x9 -o a.gif",
     2,
     {"a.gif", ".png", ".hdr", ".exr"}},
    {"HalfOfAPng", "", "dioptre render still_life --half" + small, 2, {"--half", ".exr"}},
    {"SetOnAPlainShader",
     "printf 'out vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0);\\n}\\n' >p.frag",
     "dioptre render p.frag --set trace.form=loop" + small,
     2,
     {"p.frag", "--set"}},
    {"UnknownScene", "", "dioptre render stil_life" + small, 66, {"stil_life", "did you mean 'still_life'"}},
    {"MissingFile", "", "dioptre render nowhere.toml" + small, 66, {"nowhere.toml"}},
    {"TomlSyntax", scene("[camera]\\neye = [0, 0\\n"), renderBad, 65, {"bad.toml:"}},
    {"UnknownKey",
     scene("[camera]\\neye = [0,0,5]\\nfov = 3\\n"),
     renderBad,
     65,
     {"bad.toml:3:1", "fov", "fov_y_deg"}},
    {"WrongType", scene("[camera]\\neye = \"here\"\\n"), renderBad, 65, {"bad.toml:2:7", "eye"}},
    {"MissingMaterial",
     scene("[[sphere]]\\ncentre=[0,0,0]\\nradius=1\\nmaterial=\"glas\"\\n[material.glass]\\nior=1.5\\n"),
     renderBad,
     65,
     {"bad.toml:4:10", "glas", "did you mean 'glass'"}},
    {"ZeroRadius",
     scene("[[sphere]]\\ncentre=[0,0,0]\\nradius=0\\n"),
     renderBad,
     65,
     {"bad.toml:3:8", "radius"}},
    {"ZeroAxis",
     scene("[[cylinder]]\\nbase=[0,0,0]\\naxis=[0,0,0]\\nradius=1\\n"),
     renderBad,
     65,
     {"bad.toml:3:6", "axis"}},
    {"CollinearTriangle",
     scene("[[triangle]]\\na=[0,0,0]\\nb=[1,1,1]\\nc=[2,2,2]\\n"),
     renderBad,
     65,
     {"bad.toml:", "line"}},
    {"NaN", scene("[[sphere]]\\ncentre=[0,nan,0]\\nradius=1\\n"), renderBad, 65, {"bad.toml:2:", "nan"}},
    {"MissingPicture",
     scene("[material.m]\\nimage=\"none.png\"\\n"),
     renderBad,
     66,
     {"bad.toml:2:", "none.png"}},
    {"BrokenPicture",
     "printf 'not a picture' >b.png; " +
         scene("[material.m]\\nimage=\"b.png\"\\n[[light]]\\nkind=\"ambient\"\\nambient=[1,1,1]\\n"
               "[[sphere]]\\ncentre=[0,0,0]\\nradius=1\\nmaterial=\"m\"\\n"),
     renderBad,
     65,
     {"b.png"}},
    {"PictureWithANaN",
     "printf 'uniform vec2 u_resolution;\\nout vec4 o;\\nvoid main()\\n{\\n    o = "
     "vec4(sqrt(-u_resolution.x));\\n}\\n' >n.frag; "
     "dioptre render n.frag --size 4x2 -o n.exr 2>/dev/null; " +
         scene("[sky]\\nimage=\"n.exr\"\\n"),
     renderBad,
     65,
     {"n.exr", "not a number"}},
    {"RadiusBelowFloat",
     scene("[[sphere]]\\ncentre=[0,0,0]\\nradius=1e-60\\n"),
     renderBad,
     65,
     {"bad.toml:1", "single precision"}},
    {"EdgeBelowFloat",
     scene("[[rectangle]]\\ncorner=[0,0,0]\\nedge_u=[1e-100,0,0]\\nedge_v=[0,1,0]\\n"),
     renderBad,
     65,
     {"bad.toml:1", "single precision"}},
    {"PlainShaderOfAnotherVersion",
     "printf '#version 460\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0);\\n}\\n' >p.frag",
     "dioptre render p.frag" + small,
     65,
     {"p.frag:1", "330"}},
    {"TruncatedPicture",
     "dioptre render still_life --size 64x64 --spp 1 -o whole.png 2>/dev/null; head -c 900 whole.png >b.png; "
     "rm whole.png; " +
         scene("[sky]\\nimage=\"b.png\"\\n"),
     renderBad,
     65,
     {"b.png"}},
    {"OverrideOfNothing",
     "",
     "dioptre render still_life --set trace.frm=loop" + small,
     65,
     {"--set trace.frm=loop", "form"}},
    {"OverrideOfWhatIsAnimated",
     "",
     "dioptre render orrery --set camera.eye=[0,1,5]" + small,
     2,
     {"--set camera.eye=[0,1,5]", "orrery.toml:", "animate=[]"}},
    {"AnimationOfNothing",
     scene("[[sphere]]\\nname=\"ball\"\\ncentre=[0,0,0]\\nradius=1\\n[[animate]]\\npath=\"bal.radius\"\\n"
           "times=[0,1]\\nvalues=[1,2]\\n"),
     renderBad,
     65,
     {"bad.toml:6:6", "did you mean 'ball'"}},
    {"AnimationWithABadKey",
     scene("[[sphere]]\\nname=\"ball\"\\ncentre=[0,0,0]\\nradius=1\\n[[animate]]\\npath=\"ball.radius\"\\n"
           "times=[0,1]\\nvalues=[1,0]\\n"),
     renderBad,
     65,
     {"bad.toml:8:11", "above 0", "at 1 s"}},
    {"OverrideWithoutValue", "", "dioptre render still_life --set trace.form" + small, 2, {"trace.form"}},
    {"NoSuchFolder", "", "dioptre render still_life --size 16x9 --spp 1 -o no/such/a.png", 73, {"no/such"}},
    {"OutputIsAFolder", "mkdir a.png", "dioptre render still_life" + small, 73, {"a.png"}},
    {"NoOpenGl",
     "",
     "LIBGL_DRIVERS_PATH=/nowhere __EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre render still_life --backend "
     "egl" +
         small,
     69,
     {"egl-surfaceless", "egl-device", "egl-default"}},
    {"EditedShaderBreaks",
     "cp -r \"$SOURCES/glsl\" g; ln -s \"$SOURCES/textures\" textures; echo 'float broken( {' "
     ">>g/trace/sky.glsl; export DIOPTRE_GLSL=$PWD/g",
     "dioptre render still_life" + small,
     65,
     {"sky.glsl:"}},
    {"ReferenceOfAnEditedShader",
     "cp -r \"$SOURCES/glsl\" g; ln -s \"$SOURCES/textures\" textures; echo '// edited' >>g/trace/sky.glsl; "
     "export DIOPTRE_GLSL=$PWD/g",
     "dioptre render still_life --reference" + small,
     65,
     {"edited", "build again"}},
    {"PlainShaderWithASyntaxError",
     "printf 'out vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0;\\n}\\n' >p.frag",
     "dioptre render p.frag" + small,
     65,
     {"p.frag:4"}},
    {"PlainShaderWithAStrayUniform",
     "printf 'uniform float u_x;\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(u_x);\\n}\\n' >p.frag",
     "dioptre render p.frag" + small,
     65,
     {"u_x"}},
    {"PlainShaderWithoutItsInclude",
     "printf '#include \"none.glsl\"\\nout vec4 o;\\nvoid main()\\n{\\n    o = vec4(1.0);\\n}\\n' >p.frag",
     "dioptre render p.frag" + small,
     66,
     {"p.frag:1", "none.glsl"}},
    {"BenchOfNothing", "", "dioptre bench", 2, {"inputs", "'dioptre bench --help'"}},
    {"BenchOfAnUnknownScene",
     "",
     "dioptre bench glass stil_life",
     66,
     {"stil_life", "did you mean 'still_life'"}},
    {"BenchOfAMissingFile",
     "",
     "dioptre bench me@home/no.toml@trace.budget=2",
     66,
     {"me@home/no.toml is no file"}},
    {"BenchOfAShaderThatIsUnfed",
     plainShader,
     "dioptre bench p.frag@u_speed=2 --size 8x8 --frames 2 --cold 1",
     2,
     {"u_speed", "p.frag"}},
    {"BenchInPythonOfAPlainShader", plainShader, "dioptre bench p.frag --python", 2, {"p.frag", "--python"}},
    {"BenchOverrideOfNothing",
     "",
     "dioptre bench glass glass@trace.frm=loop",
     65,
     {"glass@trace.frm=loop: ", "form"}},
    {"BenchOverrideWithoutValue", "", "dioptre bench glass@loop", 2, {"glass@loop", "path=value"}},
    {"BenchOverrideMissing", "", "dioptre bench glass@", 2, {"glass@", "path=value"}},
    {"BenchOverrideOfTheWrongKind", "", "dioptre bench glass@trace.budget=many", 65, {"trace.budget=many"}},
    {"BenchOfNoFrames", "", "dioptre bench glass --frames 0", 2, {"--frames"}},
    {"BenchOfNoColdStarts", "", "dioptre bench glass --cold 0", 2, {"--cold"}},
    {"BenchSizeOfNonsense", "", "dioptre bench glass --size 9", 2, {"--size 9", "WIDTHxHEIGHT"}},
    {"BenchOfAShaderThatBreaks",
     ownSources + "sed -i 's/^}/    undeclared = 1.0;\\n}/' own/glsl/trace/sky.glsl",
     "dioptre bench still_life --size 8x8",
     65,
     {"sky.glsl:", "undeclared", "does not compile"}},
    {"BenchWithoutOpenGl",
     "",
     "LIBGL_DRIVERS_PATH=/nowhere __EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre bench glass --backend egl",
     69,
     {"egl-surfaceless", "egl-device", "egl-default"}},
    {"BenchWithoutThePlainTracer",
     ownSources,
     "dioptre bench glass --python",
     66,
     {"own/host/command/plain_tracer.py", "--python"}},
    {"BenchWithoutPython",
     ownSources + "touch own/host/command/plain_tracer.py",
     "(PATH=/nowhere; dioptre bench glass --python)",
     69,
     {"python3", "install"}},
    {"BenchWithATracerThatFails",
     ownSources + "echo 'raise SystemExit(\"knows no glass\")' >own/host/command/plain_tracer.py",
     "dioptre bench glass --python",
     65,
     {"glass.toml", "knows no glass"}},
};

class Refusal : public testing::TestWithParam<Case>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Cases, Refusal, testing::ValuesIn(cases),
                         [](const auto& info) { return info.param.name; });

TEST_P(Refusal, NamesPlaceAndMend_LeavesNothing)
{
    const auto& refused = GetParam();
    const auto outcome =
        run("cd $(mktemp -d); trap 'rm -rf \"$PWD\"' EXIT; SOURCES='" DIOPTRE_SOURCE_DIR "'; " +
            (refused.setUp.empty() ? std::string(":") : refused.setUp) + "\nls -A >before 2>/dev/null; " +
            refused.command + "\ncode=$?\nls -A | diff - before >&2; exit $code");
    EXPECT_EQ(outcome.code, refused.code) << outcome.error;
    EXPECT_EQ(outcome.out, "");
    for (const auto& fragment : refused.says)
        EXPECT_NE(outcome.error.find(fragment), std::string::npos)
            << "'" << fragment << "' not in: " << outcome.error;
    // diff prints "<" or ">" lines where a file appeared or went.
    EXPECT_EQ(outcome.error.find("\n< "), std::string::npos) << outcome.error;
    EXPECT_EQ(outcome.error.find("\n> "), std::string::npos) << outcome.error;
}
