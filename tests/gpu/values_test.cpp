// The suite's rows of optics and of paths on this machine's software driver.
#include "gl/limits.h"
#include "render/exact_arithmetic.h"
#include "render/probe.h"
#include "stability/value_run.h"
#include "support/process.h"
#include "support/rendering.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <unistd.h>

using namespace dioptre;
using dioptre::test::contextFor;
using dioptre::test::glslFolder;

namespace
{

std::vector<std::string> namesOfRows()
{
    std::vector<std::string> names;
    for (const ValueRow& row : valueRows())
        names.emplace_back(row.name);
    return names;
}

class Values : public testing::TestWithParam<std::string>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Rows, Values, testing::ValuesIn(namesOfRows()),
                         [](const auto& info) { return info.param; });

// A twentieth of a full run, but at least what the shares of wrong itineraries rest on.
TEST_P(Values, Ours_PassAndTheTextbooksFailUnlessARowIsControl)
{
    contextFor("auto");
    const KernelDevice device{glslFolder(),
                              guardOf(testExactArithmetic(glslFolder(), deviceLimits().gpuShader5))};
    const ValueRow& row = valueRow(GetParam());
    const ValueOutcome outcome =
        checkValues(device, row, 1, std::max(row.count / 20, std::min<std::size_t>(row.count, 2000)));
    EXPECT_EQ(outcome.verdict.reason, "") << figureText(row, outcome.ours);
    EXPECT_EQ(outcome.textbookVerdict.pass, row.control) << outcome.textbookVerdict.reason;
}

TEST(ValueShaders, GlslangValidator_AcceptsThemAsGlsl330)
{
    const auto file =
        std::filesystem::temp_directory_path() / ("dioptre-values-" + std::to_string(getpid()) + ".frag");
    for (const ValueRow& row : valueRows())
        for (const bool textbook : {false, true}) {
            std::set<std::string> features(row.features.begin(), row.features.end());
            if (textbook)
                features.insert("HAS_TEXTBOOK");
            std::ofstream(file) << flatten(probeText(glslFolder(), std::string(row.shader), features));
            const auto outcome = dioptre::test::run("glslangValidator -C '" + file.string() + "'");
            EXPECT_EQ(outcome.code, 0) << row.name << "\n" << outcome.out;
        }
    std::filesystem::remove(file);
}
