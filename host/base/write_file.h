// Writing a whole file at once.
#pragma once

#include <filesystem>
#include <string_view>

namespace dioptre
{

// Puts the bytes under `path` by way of a PendingFile: all of them or nothing. Throws cannotWrite.
void writeFile(const std::filesystem::path& path, std::string_view bytes);

} // namespace dioptre
