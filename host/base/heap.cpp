#include "base/heap.h"

#include <cstdint>
#include <cstdlib>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>
#endif

namespace dioptre
{

#ifdef __GLIBC__
namespace
{

constexpr int MiB = 1 << 20;
constexpr int reserve = 256 * MiB; // address space; memory is taken as it is used

// What the heap grew by is asked to be of large pages; one that is not touched costs nothing.
void adviseLargePages(std::uintptr_t begin, std::uintptr_t end)
{
    constexpr std::uintptr_t largePage = 2 * MiB;
    begin = (begin + largePage - 1) & ~(largePage - 1);
    if (begin < end)
        ::madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE); // advice: failing is no harm
}

} // namespace

void keepLargeBlocks()
{
    ::mallopt(M_MMAP_THRESHOLD, reserve); // larger blocks go back to the system when freed
    ::mallopt(M_TRIM_THRESHOLD, reserve);
    ::mallopt(M_TOP_PAD, reserve);
    ::mallopt(M_ARENA_MAX, 1); // threads share that heap
    const auto begin = reinterpret_cast<std::uintptr_t>(::sbrk(0));
    void* volatile block = std::malloc(MiB); // more than is left: the heap grows by this and the padding
    std::free(block);
    const auto end = reinterpret_cast<std::uintptr_t>(::sbrk(0));
    // Under a limit of memory a heap that asks for so much at once gets nothing: back to the usual steps.
    // Freeing the block may have trimmed a little of what it did get.
    if (end - begin < reserve / 2) {
        ::mallopt(M_MMAP_THRESHOLD, 128 << 10);
        ::mallopt(M_TOP_PAD, 128 << 10);
    }
    adviseLargePages(begin, end);
}
#else
void keepLargeBlocks() {}
#endif

} // namespace dioptre
