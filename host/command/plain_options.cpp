#include "command/plain_options.h"

#include <charconv>
#include <cmath>
#include <string_view>

namespace dioptre
{
namespace
{

// "120,80" or "120,80,down".
Pointer pointerIn(const std::string& option)
{
    std::string_view text = option;
    Pointer pointer;
    pointer.down = text.ends_with(",down");
    pointer.pressed = pointer.down;
    if (pointer.down)
        text.remove_suffix(5);
    const auto comma = text.find(',');
    const auto read = [](std::string_view word, double& value) {
        const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
        return !word.empty() && fault == std::errc() && end == word.data() + word.size() &&
               std::isfinite(value);
    };
    if (comma == std::string_view::npos || !read(text.substr(0, comma), pointer.at_px.x) ||
        !read(text.substr(comma + 1), pointer.at_px.y))
        fail(ExitCode::usage, "--mouse " + option + " is no place of the pointer",
             "write X,Y in pixels from the lower left corner, and ,down where a button is held");
    pointer.drag_px = pointer.press_px = pointer.at_px;
    return pointer;
}

} // namespace

PlainValues plainValues(const std::vector<std::string>& entries)
{
    PlainValues values;
    for (const auto& entry : entries) {
        const auto equals = entry.find('=');
        if (equals == std::string::npos || equals == 0)
            fail(ExitCode::usage, "--set " + entry + " has no NAME=VALUE", "as in --set u_speed=2");
        values[entry.substr(0, equals)] = entry.substr(equals + 1);
    }
    return values;
}

PlainSettings plainSettings(const RenderOptions& options)
{
    PlainSettings settings;
    for (std::size_t i = 0; i < options.channels.size(); ++i)
        settings.channels[i] = channelSource(options.channels[i], i);
    settings.frame.time_s = options.time_s;
    if (!options.mouse.empty())
        settings.frame.pointer = pointerIn(options.mouse);
    settings.values = plainValues(options.overrides);
    settings.included.assign(options.included.begin(), options.included.end());
    return settings;
}

} // namespace dioptre
