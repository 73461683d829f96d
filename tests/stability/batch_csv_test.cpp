// A user's rays as CSV, in and out.
#include "base/error.h"
#include "stability/batch_csv.h"

#include <gtest/gtest.h>

namespace dioptre
{
namespace
{

const std::string heading = "case,id,prim,p0,p1,p2,p3,p4,p5,p6,p7,p8,ox,oy,oz,dx,dy,dz,tmin,spawn\n";

std::string refusalOf(const std::string& text)
{
    try {
        readBatch(text, "rays.csv");
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        return error.what();
    }
    return "taken";
}

void expectBegins(const std::string& text, const std::string& beginning)
{
    EXPECT_EQ(text.substr(0, beginning.size()), beginning);
}

} // namespace

TEST(BatchCsv, Columns_AreFoundByName_OthersLeftAlone)
{
    const auto problems =
        readBatch("note,spawn,tmin,dz,dy,dx,oz,oy,ox,p8,p7,p6,p5,p4,p3,p2,p1,p0,prim,id,case\r\n"
                  "hello,1,0.25,-1,2,3,4,5,6,18,17,16,15,14,13,12,11,10,2,seven,mine\r\n\r\n",
                  "rays.csv");
    ASSERT_EQ(problems.size(), 1U);
    const RayProblem& problem = problems.front();
    EXPECT_EQ(problem.caseName, "mine");
    EXPECT_EQ(problem.id, "seven");
    EXPECT_EQ(problem.primitive, shapeCappedCylinder);
    for (std::size_t i = 0; i < 9; ++i)
        EXPECT_EQ(problem.p[i], 10.0 + static_cast<double>(i));
    EXPECT_EQ(problem.origin, glm::dvec3(6.0, 5.0, 4.0));
    EXPECT_EQ(problem.direction, glm::dvec3(3.0, 2.0, -1.0));
    EXPECT_EQ(problem.tMin, 0.25);
    EXPECT_TRUE(problem.spawn);
}

TEST(BatchCsv, Faults_NameTheirPlaceAndTheMend)
{
    const std::string good = "a,1,0,0,0,0,1,0,0,0,0,0,0,0,5,0,0,-1,0,0\n";
    EXPECT_EQ(refusalOf(heading + good), "taken");
    expectBegins(refusalOf(""),
                 "rays.csv:1:1: no column is called case: begin with a line of names: case,id,prim");
    expectBegins(refusalOf("case,id\n"), "rays.csv:1:1: no column is called prim");
    expectBegins(refusalOf(heading + good + "a,1,0\n"), "rays.csv:3:1: 3 fields stand under 20 names");
    expectBegins(refusalOf(heading + "a,1, 7,0,0,0,1,0,0,0,0,0,0,0,5,0,0,-1,0,0\n"),
                 "rays.csv:2:6: prim: \"7\"");
    expectBegins(refusalOf(heading + "a,1,0,0,0,0,x,0,0,0,0,0,0,0,5,0,0,-1,0,0\n"),
                 "rays.csv:2:13: p3: \"x\" will not do: write a number");
    expectBegins(refusalOf(heading + "a,1,0,0,0,0,1,0,0,0,0,0,0,0,5,0,0,-1,0,2\n"),
                 "rays.csv:2:40: spawn: \"2\"");
    expectBegins(refusalOf(heading + "a,1,0,0,0,0,,0,0,0,0,0,0,0,5,0,0,-1,0,0\n"), "rays.csv:2:13: p3: \"\"");
}

TEST(BatchCsv, Answers_HaveNineDigits_AndMissesAreZeros)
{
    RayProblem problem;
    problem.caseName = "a";
    problem.id = "b";
    problem.origin = {1.0, 0.0, 0.0};
    problem.direction = {0.0, 0.0, -2.0};
    const std::vector<RayProblem> problems{problem, problem};
    const std::vector<DeviceAnswer> answers{{true, 1.0 / 3.0, {0.0, 0.0, 2.0}},
                                            {false, 0.0, glm::dvec3(0.0)}};
    EXPECT_EQ(batchText(problems, answers), "case,id,hit,t,px,py,pz,nx,ny,nz\n"
                                            "a,b,1,0.333333333,1,0,-0.666666667,0,0,1\n"
                                            "a,b,0,0,0,0,0,0,0,0\n");
}

} // namespace dioptre
