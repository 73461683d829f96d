// Whether a file is being written by someone.
#pragma once

#include <filesystem>

namespace dioptre
{

// Whether some process has the file open for writing, links followed. False where that cannot be told:
// nothing there, no regular file, another user's, or a file system without leases. Never throws, never waits.
bool hasWriter(const std::filesystem::path& file);

} // namespace dioptre
