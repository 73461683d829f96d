#include "base/child_process.h"

#include <gtest/gtest.h>

#include <csignal>

namespace dioptre
{

TEST(ChildProcess, BothOutputsAndTheCode_ComeBackApart)
{
    const auto outcome = runChild({"sh", "-c", "echo out; echo error >&2; exit 7"});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->out, "out\n");
    EXPECT_EQ(outcome->error, "error\n");
    EXPECT_EQ(outcome->code, 7);
    EXPECT_EQ(outcome->signal, 0);
}

// More than a pipe holds, on the one that is not read first.
TEST(ChildProcess, LongOutputs_ComeBackWhole)
{
    const auto outcome = runChild({"sh", "-c", "head -c 300000 /dev/zero >&2; head -c 200000 /dev/zero"});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->error.size(), 300000U);
    EXPECT_EQ(outcome->out.size(), 200000U);
}

TEST(ChildProcess, EndedByASignal_SaysWhich)
{
    const auto outcome = runChild({"sh", "-c", "kill -9 $$"});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->signal, SIGKILL);
}

TEST(ChildProcess, ThatIsNotInstalled_IsNone)
{
    EXPECT_FALSE(runChild({"no-such-program-anywhere"}));
}

TEST(ChildProcess, Environment_IsAddedToOurs)
{
    ::setenv("DIOPTRE_TEST_KEPT", "kept", 1);
    ::setenv("DIOPTRE_TEST_CHANGED", "before", 1);
    const auto outcome = runChild({"sh", "-c", "echo $DIOPTRE_TEST_KEPT $DIOPTRE_TEST_CHANGED"},
                                  {{"DIOPTRE_TEST_CHANGED", "after"}});
    ::unsetenv("DIOPTRE_TEST_KEPT");
    ::unsetenv("DIOPTRE_TEST_CHANGED");
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->out, "kept after\n");
}

TEST(ChildProcess, StandardInput_IsEmpty)
{
    const auto outcome = runChild({"cat"});
    ASSERT_TRUE(outcome);
    EXPECT_EQ(outcome->out, "");
    EXPECT_EQ(outcome->code, 0);
}

// dd reads a block of that size into memory.
TEST(ChildProcess, PeakMemory_CountsWhatTheChildHeld)
{
    const auto outcome = runChild({"dd", "if=/dev/zero", "of=/dev/null", "bs=300M", "count=1"});
    ASSERT_TRUE(outcome);
    EXPECT_GT(outcome->peak_mib, 280.0);
}

} // namespace dioptre
