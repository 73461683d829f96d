// Refusals of bench.
#include "support/refusal.h"

using namespace dioptre::test;

namespace
{

// A copy of the sources that the program reads, to be edited.
const std::string ownSources =
    "mkdir -p own/host/command; cp -r \"$SOURCES/glsl\" own/glsl; ln -s \"$SOURCES/textures\" own/textures; "
    "export DIOPTRE_GLSL=$PWD/own/glsl; ";

const std::vector<Case> benchesCases = {
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

    {"BenchSamplesOfAPlainShader",
     plainShader,
     "dioptre bench p.frag p.frag --spp 4",
     2,
     {"--spp 4", "p.frag", "leave it out"}},
    {"BenchSizeOfManyDigits", "", "dioptre bench glass --size 99999999999x1", 2, {"99999999999x1"}},
    {"BenchOfAnEmptyScene", ": >bad.toml", "dioptre bench bad.toml", 65, {"bad.toml", "is empty"}},
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Benches, Refusal, testing::ValuesIn(benchesCases), nameOf);
