// The rows of optics and of paths: what their inputs are, and that the judge finds planted errors.
#include "base/error.h"
#include "oracle/optics.h"
#include "oracle/orbit.h"
#include "oracle/paths.h"
#include "stability/case_rows.h"
#include "stability/random_floats.h"
#include "stability/value_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace dioptre
{
namespace
{

using glm::dvec3;
using glm::dvec4;
using glm::vec4;

constexpr std::size_t count = 500;

struct Table {
    const ValueRow& row;
    std::vector<dvec4> texels;

    explicit Table(std::string_view name) : row(valueRow(name)), texels(inputsOf(row, 1, count)) {}

    std::span<const dvec4> input(std::size_t i) const
    {
        return std::span(texels).subspan(i * row.texels, row.texels);
    }
    Verdict verdictOf(const std::vector<vec4>& answers) const
    {
        return judgeValues(row, measureValues(row, texels, answers));
    }
};

vec4 toFloat(const dvec3& v, double w)
{
    return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z), static_cast<float>(w)};
}

double sineBetween(const dvec3& a, const dvec3& b)
{
    return glm::length(glm::cross(a, b)) / (glm::length(a) * glm::length(b));
}

std::vector<vec4> exactShares(const Table& table)
{
    std::vector<vec4> answers;
    for (std::size_t i = 0; i < count; ++i) {
        const FresnelShares shares = fresnelShares(table.input(i)[0].x, table.input(i)[0].y);
        answers.push_back(toFloat({shares.reflected, shares.transmitted, 0.0}, 0.0));
    }
    return answers;
}

// Each chord turns by twice the glancing angle about the centre.
std::vector<vec4> exactGallery(const Table& table)
{
    std::vector<vec4> answers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto input = table.input(i);
        const dvec3 outward = unitOf(dvec3(input[0]));
        const dvec3 d = unitOf(dvec3(input[1]));
        const double sine = -glm::dot(d, outward);
        const double turned_rad = 2.0 * input[0].w * std::asin(sine);
        const dvec3 tangent = unitOf(d + sine * outward);
        answers.push_back(
            toFloat(input[2].w * (std::cos(turned_rad) * outward + std::sin(turned_rad) * tangent), 1.0));
    }
    return answers;
}

// Orbits by the oracle, moved aside by an error that grows as asked for.
std::vector<vec4> movedOrbits(const Table& table, double growthPerBounce_log10)
{
    std::vector<vec4> answers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto input = table.input(i);
        std::vector<MirrorSphere> spheres;
        for (std::size_t k = 2; k < 6; ++k)
            if (input[k].w > 0.0)
                spheres.push_back({dvec3(input[k]), input[k].w});
        const auto orbit =
            mirrorOrbit(spheres, dvec3(input[0]), dvec3(input[1]), static_cast<int>(input[0].w));
        double itinerary = 0.0;
        for (const OrbitStop& stop : orbit)
            itinerary = 4.0 * itinerary + stop.sphere;
        const auto early = static_cast<std::size_t>(input[1].w);
        const double grown =
            1e-4 * std::pow(10.0, growthPerBounce_log10 * static_cast<double>(orbit.size() - early));
        answers.push_back(toFloat(orbit.back().point + dvec3(grown, 0.0, 0.0), itinerary));
        answers.push_back(toFloat(orbit[early - 1].point + dvec3(1e-4, 0.0, 0.0), 0.0));
    }
    return answers;
}

} // namespace

TEST(ValueRows, Names_AreUniqueAndNoCaseOfAnIntersection)
{
    std::set<std::string_view> names;
    for (const CaseRow& row : caseRows())
        names.insert(row.name);
    for (const ValueRow& row : valueRows())
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
}

TEST(ValueRows, UnknownName_IsAFaultOfUse)
{
    try {
        valueRow("Q77");
        FAIL();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::usage);
        EXPECT_NE(std::string(error.what()).find("W05"), std::string::npos) << error.what();
    }
}

TEST(ValueRows, Inputs_AreTheSameForTheSameSeedAndOthersForAnother)
{
    for (const ValueRow& row : valueRows()) {
        const auto inputs = inputsOf(row, 3, 20);
        ASSERT_EQ(inputs.size(), 20 * row.texels) << row.name;
        EXPECT_EQ(inputs, inputsOf(row, 3, 20)) << row.name;
        EXPECT_NE(inputs, inputsOf(row, 4, 20)) << row.name;
    }
}

// But for ratios of indices, which the host sends rounded from double precision, and for a cone's width.
TEST(ValueRows, Places_AreFloats)
{
    for (const ValueRow& row : valueRows()) {
        if (row.name.front() == 'F')
            continue;
        const auto inputs = inputsOf(row, 1, 50);
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const bool bending = (row.name == "B01" && i % row.texels == 3) || i % row.texels == 5;
            if (bending && row.name.front() == 'B')
                continue;
            EXPECT_EQ(dvec3(inputs[i]), asFloat(dvec3(inputs[i]))) << row.name << " texel " << i;
        }
    }
}

TEST(NearCritical, Angles_LieWithinTheReachOnBothSides)
{
    const Table table("N02");
    double least = 1.0, most = -1.0;
    for (std::size_t i = 0; i < count; ++i) {
        const auto input = table.input(i);
        const double off = std::asin(sineBetween(dvec3(input[0]), dvec3(input[1]))) - std::asin(input[0].w);
        least = std::min(least, off);
        most = std::max(most, off);
    }
    // Rounded directions turn by 2^-24 or so.
    EXPECT_NEAR(least, -1e-6, 2.5e-7);
    EXPECT_NEAR(most, 1e-6, 2.5e-7);
}

TEST(Rough, HalfVectors_ReachTenWidths)
{
    const Table table("G01");
    double widest = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        widest = std::max(widest, sineBetween(dvec3(table.input(i)[0]), dvec3(table.input(i)[1])) / 1e-4);
    EXPECT_GT(widest, 9.5);
    EXPECT_LT(widest, 10.01);
}

TEST(Slab, Thickness_IsTenMicrometresButForRounding)
{
    for (const char* name : {"B02", "B03"}) {
        const Table table(name);
        for (std::size_t i = 0; i < count; ++i) {
            const auto input = table.input(i);
            const double thickness_m = glm::dot(dvec3(input[2]) - dvec3(input[3]), unitOf(dvec3(input[4])));
            EXPECT_NEAR(thickness_m, 1e-5, table.row.name == "B02" ? 4e-6 : 1e-9);
            EXPECT_NEAR(glm::length(dvec3(input[2]) - dvec3(input[0])), 20.0, 0.01);
        }
    }
}

TEST(Orbits, Starts_LastThroughTheirBouncesInQuadPrecision)
{
    for (const char* name : {"X01", "X02", "X03"}) {
        const Table table(name);
        for (std::size_t i = 0; i < 50; ++i) {
            const auto input = table.input(i);
            std::vector<MirrorSphere> spheres;
            for (std::size_t k = 2; k < 6; ++k)
                if (input[k].w > 0.0)
                    spheres.push_back({dvec3(input[k]), input[k].w});
            const auto bounces = static_cast<int>(input[0].w);
            EXPECT_EQ(mirrorOrbit(spheres, dvec3(input[0]), dvec3(input[1]), bounces).size(),
                      static_cast<std::size_t>(bounces))
                << name << " " << i;
        }
    }
}

TEST(ValueJudge, ExactAnswersRoundedToFloat_Pass)
{
    const Table fresnel("F02");
    const Table gallery("W03");
    EXPECT_EQ(fresnel.verdictOf(exactShares(fresnel)).reason, "");
    EXPECT_EQ(gallery.verdictOf(exactGallery(gallery)).reason, "");
}

TEST(ValueJudge, OneAnswerBeyondTheGate_IsFound)
{
    const Table fresnel("F02");
    auto shares = exactShares(fresnel);
    shares[217].x *= 1.000003F;
    EXPECT_NEAR(measureValues(fresnel.row, fresnel.texels, shares).figures[0].value, 3e-6, 1e-7);
    EXPECT_FALSE(fresnel.verdictOf(shares).pass);
    const Table gallery("W03");
    auto places = exactGallery(gallery);
    places[5].y += 2e-6F;
    EXPECT_FALSE(gallery.verdictOf(places).pass);
}

TEST(ValueJudge, NonFiniteAnswer_IsCountedAndFails)
{
    const Table fresnel("F02");
    auto shares = exactShares(fresnel);
    shares[3].x = std::numeric_limits<float>::infinity();
    shares[4].y = std::numeric_limits<float>::quiet_NaN();
    const ValueFigures figures = measureValues(fresnel.row, fresnel.texels, shares);
    EXPECT_EQ(figures.nonFinite, 2U);
    EXPECT_EQ(figures.figures[0].judged, count - 2);
    EXPECT_FALSE(judgeValues(fresnel.row, figures).pass);
}

TEST(ValueJudge, MissedSurface_FailsThoughThePlaceIsRight)
{
    const Table gallery("W03");
    auto places = exactGallery(gallery);
    places[99].w = 0.0F;
    EXPECT_NE(gallery.verdictOf(places).reason.find("missed/1e6 2e+03"), std::string::npos)
        << gallery.verdictOf(places).reason;
}

TEST(ValueJudge, RowWithoutAnyAnswer_Fails)
{
    const ValueRow& row = valueRow("F02");
    EXPECT_NE(judgeValues(row, measureValues(row, {}, {})).reason.find("rests on no answer"),
              std::string::npos);
}

TEST(ValueJudge, FlipsOfTotalReflection_AreCountedPerMillion)
{
    const Table table("N01");
    std::vector<vec4> answers;
    for (std::size_t i = 0; i < count; ++i) {
        const auto input = table.input(i);
        const bool total = !snellDirection(dvec3(input[0]), dvec3(input[1]), input[0].w);
        answers.push_back(toFloat({total ? 1.0 : 0.0, 0.0, 0.0}, 0.0));
    }
    EXPECT_TRUE(table.verdictOf(answers).pass);
    answers[10].x = 1.0F - answers[10].x;
    EXPECT_DOUBLE_EQ(measureValues(table.row, table.texels, answers).figures[0].value, 1e6 / count);
    EXPECT_FALSE(table.verdictOf(answers).pass);
}

// Between two spheres 2.5 radii apart errors grow by 10^0.418 a bounce along the line of their centres.
TEST(ValueJudge, OrbitsWhoseErrorsDoNotGrowAsTheyMust_Fail)
{
    const Table table("X02");
    const std::vector<vec4> moved = movedOrbits(table, 0.0);
    double sum = 0.0;
    for (std::size_t i = 0; i < count; ++i)
        sum += table.row.measure(table.input(i), std::span(moved).subspan(2 * i, 2))[2];
    const double mean = sum / static_cast<double>(count) / 7.0; // bounces 3 to 10
    EXPECT_GT(mean, 0.35);
    EXPECT_LT(mean, 0.75);
    EXPECT_EQ(table.verdictOf(movedOrbits(table, mean)).reason, "");
    EXPECT_FALSE(table.verdictOf(movedOrbits(table, 0.75 * mean)).pass);
}

TEST(ValueJudge, WrongItineraries_FailFromOneInAHundredOn)
{
    const Table table("X01");
    const double growth = 1.0; // per bounce; twoSphereGrowth_log10(6, 1) is 0.996
    auto answers = movedOrbits(table, growth);
    const ValueFigure exact = measureValues(table.row, table.texels, answers).figures[0];
    EXPECT_EQ(exact.value, 0.0);
    for (std::size_t i = 0; i < 6; ++i)
        answers[2 * i].w = -1.0F;
    EXPECT_DOUBLE_EQ(measureValues(table.row, table.texels, answers).figures[0].value, 6e6 / count);
    EXPECT_FALSE(table.verdictOf(answers).pass);
}

} // namespace dioptre
