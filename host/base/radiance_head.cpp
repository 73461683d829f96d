#include "base/radiance_head.h"

#include "base/picture_codecs.h"

#include <fmt/format.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cstdio>

namespace dioptre
{
namespace
{

// KEY=VALUE lines, as Radiance's own tools write them; a line break in a value would end the line.
std::string headerLines(const Settings& settings)
{
    std::string lines;
    for (const auto& [key, value] : settings) {
        std::string line = key + "=" + value;
        std::ranges::replace(line, '\n', ' ');
        lines += line + "\n";
    }
    return lines;
}

std::string nextLine(const std::filesystem::path& path, std::istream& in)
{
    std::string line;
    if (!std::getline(in, line) || in.eof())
        failBroken(path, "its header does not end");
    return line;
}

} // namespace

void appendTo(void* text, void* bytes, int size)
{
    static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

std::string radianceText(const RadianceHead& head)
{
    std::string text;
    const std::array<float, 3> black{};
    stbi_write_hdr_to_func(appendTo, &text, 1, 1, 3, black.data());
    text.resize(text.find("\n\n") + 2); // what follows is that pixel's
    text.insert(text.find('\n') + 1, headerLines(head.settings));
    return text + fmt::format("-Y {} +X {}\n", head.height, head.width);
}

RadianceHead readRadianceHead(const std::filesystem::path& path, std::istream& in)
{
    RadianceHead head;
    if (!nextLine(path, in).starts_with("#?R"))
        failBroken(path, "it is no Radiance picture");
    for (std::string line = nextLine(path, in); !line.empty(); line = nextLine(path, in)) {
        const std::size_t equals = line.find('=');
        const std::string key = line.substr(0, equals);
        if (key == "FORMAT" && line != "FORMAT=32-bit_rle_rgbe")
            failBroken(path, line + " is not 32-bit_rle_rgbe");
        // The format's own keys are no settings.
        if (!line.starts_with('#') && equals != std::string::npos && key != "FORMAT" && key != "EXPOSURE")
            head.settings[key] = line.substr(equals + 1);
    }
    const std::string size = nextLine(path, in);
    if (std::sscanf(size.c_str(), "-Y %9d +X %9d", &head.height, &head.width) != 2)
        failBroken(path, "its size line must read -Y height +X width");
    return head;
}

} // namespace dioptre
