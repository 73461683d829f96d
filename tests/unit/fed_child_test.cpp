#include "base/fed_child.h"

#include "base/error.h"
#include "base/interruption.h"

#include <gtest/gtest.h>

#include <csignal>

namespace dioptre
{
namespace
{

std::vector<std::uint8_t> letters(std::size_t count)
{
    return std::vector<std::uint8_t>(count, 'a');
}

} // namespace

// More than a pipe holds.
TEST(FedChild, AllThatIsWritten_ReachesIt)
{
    const auto child = FedChild::start({"sh", "-c", "wc -c; exit 3"});
    ASSERT_TRUE(child);
    for (int i = 0; i < 3; ++i)
        EXPECT_TRUE(child->write(letters(100000)));
    const auto outcome = child->finish();
    EXPECT_EQ(outcome.error, "300000\n");
    EXPECT_EQ(outcome.code, 3);
}

// SIGPIPE would end the tests.
TEST(FedChild, ThatReadsNoMore_IsToldOfAndItsWordsAreKept)
{
    const auto child = FedChild::start({"sh", "-c", "echo enough >&2; exit 4"});
    ASSERT_TRUE(child);
    bool reads = true;
    for (int i = 0; i < 10 && reads; ++i) // more than a pipe holds
        reads = child->write(letters(100000));
    EXPECT_FALSE(reads);
    const auto outcome = child->finish();
    EXPECT_EQ(outcome.error, "enough\n");
    EXPECT_EQ(outcome.code, 4);
}

TEST(FedChild, ThatPrintsMuch_IsNotHeldUp)
{
    const auto child = FedChild::start({"sh", "-c", "head -c 300000 /dev/zero >&2; cat >/dev/null"});
    ASSERT_TRUE(child);
    EXPECT_TRUE(child->write(letters(300000)));
    EXPECT_EQ(child->finish().error.size(), 300000U);
}

TEST(FedChild, LeftAlone_IsEnded)
{
    const auto child = FedChild::start({"sleep", "1000"});
    ASSERT_TRUE(child);
} // hangs where it is not

TEST(FedChild, ThatIsNotInstalled_IsNone)
{
    EXPECT_FALSE(FedChild::start({"no-such-program-anywhere"}));
}

TEST(Interruption, TheFirstSignal_IsNoted)
{
    const Interruption interruption;
    EXPECT_EQ(Interruption::signal(), 0);
    EXPECT_NO_THROW(Interruption::check());
    std::raise(SIGTERM);
    EXPECT_EQ(Interruption::signal(), SIGTERM);
    EXPECT_THROW(Interruption::check(), Error);
}

TEST(Interruption, ASecondSignal_EndsTheProcess)
{
    EXPECT_EXIT(
        {
            const Interruption interruption;
            std::raise(SIGTERM);
            std::raise(SIGTERM);
        },
        testing::KilledBySignal(SIGTERM), "");
}

TEST(Interruption, WhatWasIgnored_StaysIgnored)
{
    auto* const before = std::signal(SIGHUP, SIG_IGN);
    {
        const Interruption interruption;
        std::raise(SIGHUP);
        EXPECT_EQ(Interruption::signal(), 0);
    }
    std::signal(SIGHUP, before);
}

} // namespace dioptre
