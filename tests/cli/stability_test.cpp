// `dioptre stability` as a user meets it.
#include "support/process.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

using dioptre::test::Outcome;
using dioptre::test::run;

namespace
{

// In an empty folder that is gone afterwards.
Outcome inAFolder(const std::string& commands)
{
    return run("cd $(mktemp -d) && trap 'rm -rf \"$PWD\"' EXIT && " + commands);
}

void expectHas(const std::string& text, const std::string& part)
{
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' not in\n" << text;
}

const std::string csvNames = "case,id,prim,p0,p1,p2,p3,p4,p5,p6,p7,p8,ox,oy,oz,dx,dy,dz,tmin,spawn";

} // namespace

TEST(StabilityCommand, Cases_AreJudgedBesideTheTextbook)
{
    const Outcome outcome = inAFolder("dioptre stability S02 S08 --rays 1000 --csv t.csv && cat t.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    expectHas(outcome.out, "pass; textbook fails");
    expectHas(outcome.out, "pass; textbook passes (control)");
    expectHas(outcome.out, "2 of 2 cases pass on ");
    expectHas(outcome.out, "\nS02,ours,1000,");
    expectHas(outcome.out, "\nS02,textbook,1000,");
}

TEST(StabilityCommand, Json_HoldsEveryFigure_TheSameForTheSameSeed)
{
    const std::string command = "dioptre stability S01 C01 --rays 500 --seed 7 --json";
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    const auto json = nlohmann::json::parse(outcome.out);
    ASSERT_EQ(json["cases"].size(), 2U);
    for (const auto& row : json["cases"]) {
        EXPECT_EQ(row["rays"], 500);
        EXPECT_TRUE(row["pass"]);
        EXPECT_GT(row["k_max"].get<double>(), 0.1);
        EXPECT_LT(row["k_max"].get<double>(), row["textbook"]["k_max"].get<double>());
        for (const char* key :
             {"t_rel_max", "flips_per_million", "normal_rad_max", "nonfinite", "gate", "about"})
            EXPECT_TRUE(row.contains(key)) << key;
    }
    EXPECT_EQ(run(command).out, outcome.out);
    EXPECT_NE(run("dioptre stability S01 C01 --rays 500 --seed 8 --json").out, outcome.out);
}

// A kernel that is wrong in one factor.
TEST(StabilityCommand, BrokenGate_EndsWith1AndSaysWhich)
{
    const Outcome outcome =
        inAFolder("cp -r '" DIOPTRE_SOURCE_DIR "/glsl' g && "
                  "sed -i 's/vec2 reach = fineSum(square, -fineDot(foot, foot))/vec2 reach = fineSum(square, "
                  "-0.99 * fineDot(foot, foot))/' g/kernel/fine_round.glsl && "
                  "! cmp -s g/kernel/fine_round.glsl '" DIOPTRE_SOURCE_DIR "/glsl/kernel/fine_round.glsl' && "
                  "DIOPTRE_GLSL=$PWD/g dioptre stability S01 P01 --rays 1000");
    EXPECT_EQ(outcome.code, 1) << outcome.out << outcome.error;
    expectHas(outcome.out, "FAIL: K ");
    expectHas(outcome.out, "1 of 2 cases pass");
}

TEST(StabilityCommand, UnknownCase_IsRefusedBeforeAnythingRuns)
{
    const Outcome outcome = run("dioptre stability S01 S99");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    expectHas(outcome.error, "\"S99\"");
    expectHas(outcome.error, "it is one of S01, S02");
}

TEST(StabilityCommand, UsersRays_AreAnsweredLineByLine)
{
    const Outcome outcome = inAFolder("printf '" + csvNames +
                                      "\\na,1,0,0,0,0,1,0,0,0,0,0,0,0,5,0,0,-2,0,0\\n"
                                      "a,2,0,0,0,0,1,0,0,0,0,0,0,3,5,0,0,-1,0,0\\n"
                                      "b,3,0,0,-1e7,0,1e7,0,0,0,0,0,0.5,2,0,0,-1,0,0,0\\n' >rays.csv && "
                                      "dioptre stability --input rays.csv --output hits.csv && cat hits.csv");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    expectHas(outcome.out,
              "case,id,hit,t,px,py,pz,nx,ny,nz\na,1,1,2,0,0,1,0,0,1\na,2,0,0,0,0,0,0,0,0\nb,3,1,2,0.5,");
    expectHas(outcome.error, "3 rays, 2 hits");
}

TEST(StabilityCommand, BadRays_LeaveNoOutput)
{
    const Outcome outcome = inAFolder("printf '" + csvNames +
                                      "\\na,1,0,0,0,0,one,0,0,0,0,0,0,0,5,0,0,-2,0,0\\n' >rays.csv && "
                                      "dioptre stability --input rays.csv --output hits.csv; echo $?; ls");
    expectHas(outcome.error, "rays.csv:2:13: p3: \"one\" will not do: write a number");
    EXPECT_EQ(outcome.out, "65\nrays.csv\n");
}

TEST(StabilityCommand, Plot_HasALineForEachVariant)
{
    const Outcome outcome =
        inAFolder("dioptre stability P01 --rays 100 --plot p.svg >/dev/null && cat p.svg");
    EXPECT_EQ(outcome.code, 0) << outcome.error;
    for (const char* name : {"textbook", "robust", "compensated", "curvature"})
        expectHas(outcome.out, std::string(">") + name + "</text>");
    EXPECT_EQ(outcome.out.find("nan"), std::string::npos);
}
