// A line that says how much is done and how long the rest takes; on a terminal alone.
#pragma once

#include <cstddef>
#include <functional>

namespace dioptre
{

// A function to tell the share done, 0..1; empty where standard error is no terminal. Says nothing in the
// first second.
std::function<void(double)> terminalProgress();

// The same for a run of so many frames, to be told how many are done; parts of them count.
std::function<void(double)> terminalProgressOfFrames(std::size_t frames);

} // namespace dioptre
