// The file of a prepared picture in the cache: a checksum, the levels' sizes and the raw numbers.
#pragma once

#include "base/picture.h"

#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// Puts the levels, at most 16, under `path`: all of them or nothing. Throws cannotWrite.
void writeEntry(const std::filesystem::path& path, const std::string& key,
                const std::vector<Picture>& levels);

// What writeEntry put there under the same key, bit for bit; nothing where there is no such file, where it
// was written under another key, or where it is not whole.
std::optional<std::vector<Picture>> readEntry(const std::filesystem::path& path, const std::string& key);

// The size of the file that writeEntry makes.
std::uintmax_t entryBytes(const std::vector<Picture>& levels);

} // namespace dioptre
