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

// A planet of 1e7 m under an eye 2.3 m above it: a product with the centre's square loses the height.
TEST(StabilityCommand, Variant_OfUsersRays_IsTheOneAskedFor)
{
    const auto answer = [](const std::string& variant) {
        return inAFolder("printf '" + csvNames +
                         "\\np,1,0,0,-1e7,0,1e7,0,0,0,0,0,0.5,2.3,0,0.6,-0.8,0,0,0\\n' >rays.csv && "
                         "dioptre stability --input rays.csv --variant " +
                         variant);
    };
    const auto timeIn = [](const Outcome& outcome) { // p,1,hit,t,...
        const auto row = outcome.out.find("\np,1,1,");
        return row == std::string::npos ? 0.0 : std::stod(outcome.out.substr(row + 7));
    };
    // 2.3 / 0.8, and what the planet's curve adds: (0.5 + 1.725)^2 / 2e7 / 0.8.
    for (const char* variant : {"auto", "compensated", "curvature"})
        EXPECT_NEAR(timeIn(answer(variant)), 2.875 + 3.1e-7, 1e-6) << variant;
    EXPECT_GT(std::abs(timeIn(answer("textbook")) - 2.875), 0.1);
    const Outcome refused = answer("sturdy");
    EXPECT_EQ(refused.code, 2);
    expectHas(refused.error, "curvature");
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
