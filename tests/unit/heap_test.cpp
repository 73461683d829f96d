#include "base/heap.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <sys/resource.h>

namespace dioptre
{
namespace
{

long pageFaults()
{
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_minflt;
}

void useBlock(std::size_t bytes)
{
    void* volatile block = std::malloc(bytes);
    std::memset(block, 1, bytes);
    std::free(block);
}

// 32 MiB are 8192 pages of 4 KiB.
long faultsOfABlockTakenAgain()
{
    constexpr std::size_t bytes = std::size_t{32} << 20;
    keepLargeBlocks();
    useBlock(bytes);
    const long before = pageFaults();
    useBlock(bytes);
    return pageFaults() - before;
}

TEST(KeepLargeBlocks, BlockTakenAgain_CostsNoPageFaults)
{
#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
    GTEST_SKIP() << "another malloc";
#endif
    // In a process of its own, as at the start of the program: other tests leave another heap behind.
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_EXIT(std::exit(faultsOfABlockTakenAgain() < 100 ? 0 : 1), testing::ExitedWithCode(0), "");
}

} // namespace
} // namespace dioptre
