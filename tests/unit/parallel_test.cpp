#include "base/parallel.h"

#include <gtest/gtest.h>

#include <array>
#include <atomic>
#include <stdexcept>
#include <string>

namespace dioptre
{
namespace
{

TEST(InParallel, EveryIndex_IsWorkedOnOnce)
{
    std::array<std::atomic<int>, 100> calls{};
    inParallel(calls.size(), [&](std::size_t i) { ++calls[i]; });
    for (const auto& count : calls)
        EXPECT_EQ(count, 1);
}

TEST(InParallel, NoWork_ReturnsAtOnce)
{
    inParallel(0, [](std::size_t) { FAIL(); });
}

TEST(InParallel, LowestFault_IsThrownWhenAllIsDone)
{
    std::atomic<int> done = 0;
    const auto work = [&](std::size_t i) {
        ++done;
        if (i == 7 || i == 3)
            throw std::runtime_error(std::to_string(i));
    };
    try {
        inParallel(10, work);
        FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& fault) {
        EXPECT_STREQ(fault.what(), "3");
    }
    EXPECT_EQ(done, 10);
}

} // namespace
} // namespace dioptre
