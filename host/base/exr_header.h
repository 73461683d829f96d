// What an EXR's headers claim, checked before OpenEXR takes memory for it.
#pragma once

#include <filesystem>
#include <string>

namespace dioptre
{

// `bytes` is a whole file that begins as an EXR does. Throws badInput where a header's attribute is longer
// than the file, a window is larger than a picture may be, or there are more chunks than the file could list.
void checkExrHeaders(const std::filesystem::path& path, const std::string& bytes);

} // namespace dioptre
