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

// How a line begins, up to the message: a pattern of sscanf that reads the line's number and, with %n, how
// far the pattern reaches. The number before it is the source's; the one in brackets behind it the column.
struct LogFormat {
    const char* prefix;
    const char* severity; // "" where the message itself says it
};

constexpr std::array<LogFormat, 7> logFormats{{
    {"%*9u:%9d(%*9u): %n", ""},               // Mesa
    {"%*9u:%9d: %n", ""},                     // Mesa without a column
    {"%*9u(%9d) : %n", ""},                   // NVIDIA
    {"ERROR: %*9u:%9d: %n", "error: "},       // AMD, Intel, ANGLE, glslang
    {"ERROR: %*9u:%9d(%*9u): %n", "error: "}, // the same with a column
    {"WARNING: %*9u:%9d: %n", "warning: "},
    {"WARNING: %*9u:%9d(%*9u): %n", "warning: "},
}};

LogMessage parseLine(const std::string& line)
{
    for (const LogFormat& format : logFormats) {
        int number = 0, reached = 0;
        if (std::sscanf(line.c_str(), format.prefix, &number, &reached) == 1 && reached > 0)
            return {number, format.severity + line.substr(static_cast<std::size_t>(reached))};
    }
    return {0, line};
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
