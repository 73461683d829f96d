// The one exception of the program, thrown at its boundaries (files, TOML, OpenGL, command line).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace dioptre
{

// What the process tells its caller; only main() turns an Error into one of these.
enum class ExitCode : int {
    done = 0,
    checkFailed = 1,
    usage = 2,
    badInput = 65,
    inputMissing = 66,
    noOpenGl = 69,
    toolMissing = 69, // a program that an option asks for
    cannotWrite = 73,
    retry = 75
};

// A place in a text that the user wrote; line and column count from 1, 0 where unknown.
struct SourcePosition {
    std::string path;
    int line = 0;
    int column = 0;
};

// "path:line:column" with the unknown parts left out.
std::string describe(const SourcePosition& where);

class Error : public std::runtime_error
{
public:
    Error(ExitCode code, const std::string& message);
    ExitCode code() const;

private:
    ExitCode code_;
};

// Throws an Error that reads "path:line:column: what: mend"; the mend says how to put it right.
[[noreturn]] void fail(ExitCode code, const SourcePosition& where, std::string_view what,
                       std::string_view mend);

// As above, for faults that have no place in a text: "what: mend".
[[noreturn]] void fail(ExitCode code, std::string_view what, std::string_view mend);

} // namespace dioptre
