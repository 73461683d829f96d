#include "live/live_input.h"

#include "base/error.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace dioptre
{

LiveInput findLiveInput(const std::string& text)
{
    const std::filesystem::path path(text);
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::array<std::string, 3> encoded{".png", ".jpg", ".jpeg"};
    const std::array<std::string, 2> linear{".hdr", ".exr"};
    const bool isLinear = std::ranges::find(linear, extension) != linear.end();
    if (!isLinear && std::ranges::find(encoded, extension) == encoded.end())
        return {findInput(text), "", false};
    if (!std::filesystem::is_regular_file(path))
        fail(ExitCode::inputMissing, text + " is no file that can be read", "check the path");
    return {{glslFolder() / "live" / "picture.frag", path.stem().string(), true}, path.string(), isLinear};
}

} // namespace dioptre
