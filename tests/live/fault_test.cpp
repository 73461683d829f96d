// The lines around a fault, as its panel shows them.
#include "live/fault.h"

#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace dioptre::test
{
namespace
{

using Lines = std::vector<std::string>;

class Faults : public InAFolder
{
protected:
    std::string made(const std::string& text) const
    {
        std::ofstream(folder / "a.frag", std::ios::binary) << text;
        return (folder / "a.frag").string();
    }
    static Fault at(const std::string& path, int line)
    {
        return faultOf(Error(ExitCode::badInput, "all", {{{path, line, 1}, "what", "mend"}}));
    }
    static SourceExcerpt excerptAt(const std::string& path, int line)
    {
        return at(path, line).places.at(0).excerpt;
    }
};

const std::string seven = "1\n2\n3\n4\n5\n6\n7\n";

} // namespace

TEST_F(Faults, Place_HasItsWordsAndTwoLinesOnEitherSide)
{
    const Fault fault = at(made(seven), 4);
    EXPECT_EQ(fault.text, "all");
    ASSERT_EQ(fault.places.size(), 1U);
    EXPECT_EQ(fault.places[0].complaint.what, "what");
    EXPECT_EQ(fault.places[0].complaint.mend, "mend");
    EXPECT_EQ(fault.places[0].excerpt.first, 2);
    EXPECT_EQ(fault.places[0].excerpt.lines, (Lines{"2", "3", "4", "5", "6"}));
}

TEST_F(Faults, AtTheEnds_TheLinesThatThereAre)
{
    const std::string file = made(seven);
    EXPECT_EQ(excerptAt(file, 1).first, 1);
    EXPECT_EQ(excerptAt(file, 1).lines, (Lines{"1", "2", "3"}));
    EXPECT_EQ(excerptAt(file, 7).first, 5);
    EXPECT_EQ(excerptAt(file, 7).lines, (Lines{"5", "6", "7"}));
}

// A driver that misses the closing brace names the line behind the last.
TEST_F(Faults, LineBehindTheLast_ShowsTheLast)
{
    EXPECT_EQ(excerptAt(made("1\n2"), 3).lines, (Lines{"1", "2"}));
    EXPECT_TRUE(excerptAt(made("1\n2"), 99).lines.empty());
}

TEST_F(Faults, WithoutLineOrFile_NoExcerpt)
{
    const std::string file = made(seven);
    EXPECT_TRUE(excerptAt(file, 0).lines.empty());
    EXPECT_TRUE(excerptAt("", 3).lines.empty());
    EXPECT_TRUE(excerptAt((folder / "none.frag").string(), 3).lines.empty());
    EXPECT_TRUE(excerptAt(folder.string(), 3).lines.empty());
    EXPECT_TRUE(excerptAt("--set sphere.radius=-1", 1).lines.empty());
}

TEST_F(Faults, LineEndsOfWindows_AreNotShown)
{
    EXPECT_EQ(excerptAt(made("a\r\nb\r\n"), 1).lines, (Lines{"a", "b"}));
}

TEST_F(Faults, EndlessLines_AreCut)
{
    EXPECT_EQ(excerptAt(made(std::string(100'000, 'x')), 1).lines, (Lines{std::string(200, 'x')}));
}

TEST_F(Faults, ManyFaults_TheFirstOnes_AndAllOfTheText)
{
    std::vector<Complaint> all;
    for (int i = 0; i < 500; ++i)
        all.push_back({{"", 0, 0}, std::to_string(i), ""});
    const Fault fault = faultOf(Error(ExitCode::badInput, "five hundred", all));
    ASSERT_EQ(fault.places.size(), 20U);
    EXPECT_EQ(fault.places.front().complaint.what, "0");
    EXPECT_EQ(fault.places.back().complaint.what, "19");
    EXPECT_EQ(fault.text, "five hundred");
}

} // namespace dioptre::test
