#include "gl/program.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <sstream>

namespace dioptre
{
namespace
{

// How a line begins, up to the message: a pattern of sscanf that reads the line's number, the column's where
// there is one, and, with %n, how far the pattern reaches.
struct LogFormat {
    const char* prefix;
    int numbers;            // 1, or 2 with a column
    const char* severity;   // "" where the message itself says it
    bool collapses = false; // see LogMessage; the preprocessor's own messages do not
};

// The number before the line's is the source's.
constexpr std::array<LogFormat, 7> logFormats{{
    {"%*9u:%9d(%9d): %n", 2, "", true},         // Mesa
    {"%*9u:%9d: %n", 1, ""},                    // Mesa without a column
    {"%*9u(%9d) : %n", 1, ""},                  // NVIDIA
    {"ERROR: %*9u:%9d: %n", 1, "error: "},      // AMD, Intel, ANGLE, glslang
    {"ERROR: %*9u:%9d(%9d): %n", 2, "error: "}, // the same with a column
    {"WARNING: %*9u:%9d: %n", 1, "warning: "},
    {"WARNING: %*9u:%9d(%9d): %n", 2, "warning: "},
}};

LogMessage parseLine(const std::string& line)
{
    for (const LogFormat& format : logFormats) {
        int number = 0, second = 0, third = 0;
        const int read = std::sscanf(line.c_str(), format.prefix, &number, &second, &third);
        const int reached = format.numbers == 2 ? third : second;
        if (read != format.numbers || reached == 0)
            continue;
        const std::string text = line.substr(static_cast<std::size_t>(reached));
        return {number, format.numbers == 2 ? second : 0, format.severity + text,
                format.collapses && !text.starts_with("preprocessor ")};
    }
    return {0, 0, line};
}

} // namespace

std::vector<LogMessage> parseLog(const std::string& log)
{
    std::vector<LogMessage> messages;
    std::istringstream lines(log);
    for (std::string line; std::getline(lines, line);) {
        line.erase(std::find(line.begin(), line.end(), '\0'), line.end());
        while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back())))
            line.pop_back();
        if (!line.empty())
            messages.push_back(parseLine(line));
    }
    return messages;
}

} // namespace dioptre
