// Prepared pictures kept between runs of the command.
#include "support/process.h"

#include <gtest/gtest.h>

#include <filesystem>

using dioptre::test::run;

namespace
{

// Runs in a new folder with a scene under a wall of two pictures, red.png and blue.png, each an hour old; it
// is removed afterwards.
dioptre::test::Outcome here(const std::string& command)
{
    const std::string paint =
        "paint() { printf \"out vec4 o;\\nvoid main()\\n{\\n    o = vec4($2);\\n}\\n\" >p.frag;"
        " dioptre render p.frag --size 8x8 -o $1 2>log; touch -d '1 hour ago' $1; }\n";
    const std::string scene = "printf '[camera]\\neye = [0, 0, 5]\\n[material.wall]\\nimage = \"a.png\"\\n"
                              "[[plane]]\\npoint = [0, 0, 0]\\nnormal = [0, 0, 1]\\nmaterial = \"wall\"\\n"
                              "[[light]]\\nkind = \"ambient\"\\nambient = [1, 1, 1]\\n' >a.toml\n";
    return run("folder=$(mktemp -d)\ncd $folder\n" + paint + scene +
               "draw() { dioptre render a.toml --size 8x8 --spp 1 -o $1; }\n"
               "{ " +
               command + "\n}\nstatus=$?\nrm -r $folder\nexit $status");
}

TEST(PictureCacheOfTheCommand, SecondRun_DrawsTheSameBytesFromWhatTheFirstKept)
{
    const auto outcome = here("paint a.png '1.0, 0.0, 0.0, 1.0' && DIOPTRE_CACHE=kept draw first.png && "
                              "test \"$(ls kept | wc -l)\" = 1 && touch -d '2 hours ago' kept/* marker && "
                              "DIOPTRE_CACHE=kept draw second.png && test kept/* -nt marker && "
                              "draw without.png && cmp first.png second.png && cmp first.png without.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
}

TEST(PictureCacheOfTheCommand, EditedPicture_IsSeenByTheNextRun)
{
    const auto outcome = here("export DIOPTRE_CACHE=kept\n"
                              "paint a.png '1.0, 0.0, 0.0, 1.0' && draw red.png && "
                              "paint a.png '0.0, 0.0, 1.0, 1.0' && draw blue.png && "
                              "DIOPTRE_CACHE=off draw without.png && "
                              "cmp blue.png without.png && ! cmp -s red.png blue.png");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
}

TEST(PictureCacheOfTheCommand, ItsPlace_IsTheUsersCacheUnlessTurnedOff)
{
    const auto outcome =
        here("paint a.png '1.0, 1.0, 0.0, 1.0'\nunset DIOPTRE_CACHE\n"
             "XDG_CACHE_HOME=$PWD/xdg draw a1.png && ls xdg/dioptre/*.levels && "
             "HOME=$PWD/home XDG_CACHE_HOME= MESA_SHADER_CACHE_DISABLE=1 draw a2.png && "
             "ls home/.cache/dioptre/*.levels && "
             "HOME=$PWD/other XDG_CACHE_HOME= MESA_SHADER_CACHE_DISABLE=1 DIOPTRE_CACHE=off draw a3.png && "
             "! test -e other/.cache/dioptre");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
}

} // namespace
