#include "command/frame_range.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <regex>

namespace dioptre
{
namespace
{

constexpr int largestFrame = 9'999'999; // more than four days at 25 frames a second

[[noreturn]] void refuseRange(const std::string& text, const std::string& why)
{
    fail(ExitCode::usage, "--frames " + text + ": " + why,
         "give FIRST:LAST or FIRST:LAST:STEP, as 0:99 or 0:99:5");
}

int numberFrom(const std::string& part, const std::string& text)
{
    int number = 0;
    const auto [end, fault] = std::from_chars(part.data(), part.data() + part.size(), number);
    if (part.empty() || fault != std::errc() || end != part.data() + part.size())
        refuseRange(text, "'" + part + "' is no frame's number");
    if (number < 0 || number > largestFrame)
        refuseRange(text, fmt::format("{} is not between 0 and {}", number, largestFrame));
    return number;
}

} // namespace

FrameRange readFrameRange(const std::string& text)
{
    std::vector<std::string> parts{""};
    for (const char letter : text) {
        if (letter == ':')
            parts.emplace_back();
        else
            parts.back() += letter;
    }
    if (parts.size() < 2 || parts.size() > 3)
        refuseRange(text, "these are not two or three numbers");
    FrameRange range{numberFrom(parts[0], text), numberFrom(parts[1], text), 1};
    if (parts.size() == 3)
        range.step = numberFrom(parts[2], text);
    if (range.step < 1)
        refuseRange(text, "a step is at least 1");
    if (range.first > range.last)
        refuseRange(text, fmt::format("{} is after {}", range.first, range.last));
    return range;
}

std::vector<int> numbersOf(const FrameRange& range)
{
    std::vector<int> numbers;
    for (int i = 0; i <= (range.last - range.first) / range.step; ++i)
        numbers.push_back(range.first + i * range.step);
    return numbers;
}

double timeOf(int frame, double start_s, double fps)
{
    return start_s + frame / fps;
}

FrameNames::FrameNames(const std::string& output, int largest)
{
    const std::filesystem::path path(output);
    const std::string name = path.filename().string();
    const std::string extension = path.extension().string();
    const std::string folder = output.substr(0, output.size() - name.size());
    const std::string mend = "let one run of # stand for the frame's number, as in turn_####.png";
    if (std::regex_search(name, std::regex("%[0-9]*d")))
        fail(ExitCode::usage, "-o " + output + ": a frame's number is not written %d here", mend);
    if (folder.find('#') != std::string::npos)
        fail(ExitCode::usage, "-o " + output + ": all frames go to one folder", mend);
    const auto first = name.find('#');
    const auto end = first == std::string::npos ? first : name.find_first_not_of('#', first);
    if (end != std::string::npos && name.find('#', end) != std::string::npos)
        fail(ExitCode::usage, "-o " + output + ": a frame has one number", mend);
    if (first == std::string::npos) {
        before_ = folder + path.stem().string() + ".";
        after_ = extension;
        digits_ = 4;
    } else {
        before_ = folder + name.substr(0, first);
        after_ = end == std::string::npos ? "" : name.substr(end);
        digits_ = name.size() - first - after_.size();
    }
    digits_ = std::max(digits_, std::to_string(largest).size());
}

std::string FrameNames::of(int frame) const
{
    return fmt::format("{}{:0{}}{}", before_, frame, digits_, after_);
}

std::string FrameNames::pattern() const
{
    return before_ + std::string(digits_, '#') + after_;
}

} // namespace dioptre
