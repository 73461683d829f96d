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
TEST(KeepLargeBlocks, BlockTakenAgain_CostsNoPageFaults)
{
#if defined(__SANITIZE_ADDRESS__) || !defined(__GLIBC__)
    GTEST_SKIP() << "another malloc";
#endif
    constexpr std::size_t bytes = std::size_t{32} << 20;
    keepLargeBlocks();
    useBlock(bytes);
    const long before = pageFaults();
    useBlock(bytes);
    EXPECT_LT(pageFaults() - before, 100);
}

} // namespace
} // namespace dioptre
