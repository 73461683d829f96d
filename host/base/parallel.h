// Work spread over the processor's cores.
#pragma once

#include <cstddef>
#include <functional>

namespace dioptre
{

// Calls work(0) to work(count - 1), each once, in this order but side by side, and returns when all are done.
// What the lowest index threw is thrown on.
void inParallel(std::size_t count, const std::function<void(std::size_t)>& work);

} // namespace dioptre
