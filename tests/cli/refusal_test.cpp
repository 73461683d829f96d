// Refusals of the command line itself, and what must hold of every refusal.
#include "support/process.h"
#include "support/refusal.h"

using namespace dioptre::test;

namespace
{

const std::vector<Case> usageCases = {
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
    {"SizeThatOverflows",
     "",
     "dioptre render still_life --size 4294967306x10 -o a.png",
     2,
     {"4294967306x10"}},
    {"SizeWithBlanks", "", "dioptre render still_life --size ' 16x 9' -o a.png", 2, {"WIDTHxHEIGHT"}},
    {"SizeBeyondAll", "", "dioptre render still_life --size 999999x9 -o a.png", 2, {"999999x9", "131072"}},
    {"NoSamples", "", "dioptre render still_life --spp 0 -o a.png", 2, {"--spp"}},
    {"TimeOfNonsense", "", "dioptre render orrery --time soon" + small, 2, {"--time"}},
    {"TimeThatIsNoNumber",
     "",
     "dioptre render orrery --time nan" + small,
     2,
     {"--time", "number of seconds"}},
    {"UnknownBackend", "", "dioptre render still_life --backend vulkan -o a.png", 2, {"vulkan", "osmesa"}},
    {"UnknownScene", "", "dioptre render stil_life" + small, 66, {"stil_life", "did you mean 'still_life'"}},
    {"MissingFile", "", "dioptre render nowhere.toml" + small, 66, {"nowhere.toml"}},
    {"NoOpenGl",
     "",
     "LIBGL_DRIVERS_PATH=/nowhere __EGL_VENDOR_LIBRARY_DIRS=/nowhere dioptre render still_life --backend "
     "egl" +
         small,
     69,
     {"egl-surfaceless", "egl-device", "egl-default"}},

    {"SizeOfNothing", "", "dioptre render still_life --size 0x0 -o a.png", 2, {"0x0", "131072"}},
    {"SizeBelowZero", "", "dioptre render still_life --size -1x5 -o a.png", 2, {"-1x5", "WIDTHxHEIGHT"}},
    {"SizeWithExponents", "", "dioptre render still_life --size 1e9x1e9 -o a.png", 2, {"1e9x1e9"}},
    {"SizeOfManyDigits", "", "dioptre render still_life --size 99999999999x1 -o a.png", 2, {"99999999999x1"}},
    {"SizeWithoutAHeight", "", "dioptre render still_life --size 5x -o a.png", 2, {"--size 5x "}},
    {"SizeWithoutAWidth", "", "dioptre render still_life --size x5 -o a.png", 2, {"--size x5 "}},
    {"SizeOfThree", "", "dioptre render still_life --size 5x5x5 -o a.png", 2, {"5x5x5"}},
    {"SizeWithABlank", "", "dioptre render still_life --size '5 x5' -o a.png", 2, {"5 x5"}},
    {"SizeOfNoText", "", "dioptre render still_life --size '' -o a.png", 2, {"WIDTHxHEIGHT"}},
    {"BudgetOfNothing", "", "dioptre render still_life --budget 0" + small, 2, {"--budget"}},
    {"SamplesOfManyDigits", "", "dioptre render still_life --spp 99999999999 -o a.png", 2, {"--spp"}},
    {"FramesWithoutAnEnd", "", "dioptre render orrery --frames 3 -o a.png", 2, {"--frames 3", "FIRST:LAST"}},
    {"FramesBackwards", "", "dioptre render orrery --frames 5:1 -o a.png", 2, {"5 is after 1"}},
    {"FramesBelowZero", "", "dioptre render orrery --frames=-1:5 -o a.png", 2, {"-1 is not between 0 and"}},
    {"FramesInStepsOfNothing", "", "dioptre render orrery --frames 0:5:0 -o a.png", 2, {"at least 1"}},
    {"FramesInStepsBackwards", "", "dioptre render orrery --frames 0:5:-1 -o a.png", 2, {"--frames 0:5:-1"}},
    {"FramesOfManyDigits",
     "",
     "dioptre render orrery --frames 0:99999999999 -o a.png",
     2,
     {"'99999999999' is no frame's number"}},
    {"FramesOfWords", "", "dioptre render orrery --frames a:b -o a.png", 2, {"'a' is no frame's number"}},
    {"FramesOfColons", "", "dioptre render orrery --frames : -o a.png", 2, {"--frames :"}},
    {"FramesThatTurnNoTime", "", "dioptre render orrery --frames 0:1 --fps 0 -o a.png", 2, {"--fps 0"}},
    {"FolderNamedAsAScene",
     "mkdir a.toml",
     "dioptre render a.toml" + small,
     66,
     {"a.toml", "check the path"}},
    {"SourcesThatAreNowhere",
     "",
     "export DIOPTRE_GLSL=/nowhere; dioptre render still_life" + small,
     66,
     {"DIOPTRE_GLSL=/nowhere", "ray_trace.frag"}},
    {"ListOfSourcesThatAreNowhere",
     "",
     "export DIOPTRE_GLSL=/nowhere; dioptre list",
     66,
     {"DIOPTRE_GLSL=/nowhere", "ray_trace.frag"}},
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Usage, Refusal, testing::ValuesIn(usageCases), nameOf);

void dioptre::test::PrintTo(const Case& refused, std::ostream* stream)
{
    *stream << refused.command;
}

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
