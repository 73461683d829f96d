// An Error's text and its complaints tell the same.
#include "base/error.h"

#include <gtest/gtest.h>

#include <functional>

namespace dioptre
{

namespace
{

Error thrownBy(const std::function<void()>& fault)
{
    try {
        fault();
    } catch (const Error& error) {
        return error;
    }
    ADD_FAILURE() << "nothing was thrown";
    return {ExitCode::done, ""};
}

TEST(Error, FaultInAText_IsOneComplaintAtItsPlace)
{
    const Error error = thrownBy([] {
        fail(ExitCode::badInput, {"a.toml", 3, 7}, "radius is -1", "give a number above 0");
    });
    EXPECT_STREQ(error.what(), "a.toml:3:7: radius is -1: give a number above 0");
    ASSERT_EQ(error.complaints().size(), 1U);
    EXPECT_EQ(describe(error.complaints()[0].where), "a.toml:3:7");
    EXPECT_EQ(error.complaints()[0].what, "radius is -1");
    EXPECT_EQ(error.complaints()[0].mend, "give a number above 0");
}

TEST(Error, FaultWithoutAPlace_IsOneComplaintOfAnEmptyPath)
{
    const Error error = thrownBy([] { fail(ExitCode::noOpenGl, "no OpenGL", "install Mesa"); });
    EXPECT_STREQ(error.what(), "no OpenGL: install Mesa");
    ASSERT_EQ(error.complaints().size(), 1U);
    EXPECT_EQ(error.complaints()[0].where.path, "");
    EXPECT_EQ(error.complaints()[0].what, "no OpenGL");
    EXPECT_EQ(error.complaints()[0].mend, "install Mesa");
}

TEST(Error, TextAlone_IsItsComplaint)
{
    const Error error(ExitCode::retry, "a child failed");
    ASSERT_EQ(error.complaints().size(), 1U);
    EXPECT_EQ(error.complaints()[0].what, "a child failed");
}

TEST(Error, SaidAgainInOtherWords_KeepsCodeAndComplaints)
{
    const Error error = thrownBy([] {
        try {
            fail(ExitCode::inputMissing, {"a.toml", 3, 7}, "no such file", "name another");
        } catch (const Error& fault) {
            failAgain(fault, std::string(fault.what()) + " (at 2 s)");
        }
    });
    EXPECT_EQ(error.code(), ExitCode::inputMissing);
    EXPECT_STREQ(error.what(), "a.toml:3:7: no such file: name another (at 2 s)");
    ASSERT_EQ(error.complaints().size(), 1U);
    EXPECT_EQ(error.complaints()[0].mend, "name another");
    EXPECT_EQ(error.complaints()[0].where.column, 7);
}

} // namespace

} // namespace dioptre
