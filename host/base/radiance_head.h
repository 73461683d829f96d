// The text that a Radiance picture begins with.
#pragma once

#include "base/picture.h"

#include <istream>

namespace dioptre
{

struct RadianceHead {
    int width = 0;  // pixels
    int height = 0; // pixels
    Settings settings{};
};

// What stb calls with bytes; `text` is the std::string that they are added to.
void appendTo(void* text, void* bytes, int size);

// As stb writes it, with the settings below its first line: KEY=VALUE, one a line.
std::string radianceText(const RadianceHead& head);

// Leaves the stream before the first row. Throws badInput; `path` is for the messages.
RadianceHead readRadianceHead(const std::filesystem::path& path, std::istream& in);

} // namespace dioptre
