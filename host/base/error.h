// The one exception of the program, thrown at its boundaries (files, TOML, OpenGL, command line).
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

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

// One fault of an input, apart from the sentence that is printed.
struct Complaint {
    SourcePosition where; // its path is empty where the fault has no place in a text
    std::string what;     // of a driver's message the whole: "error: `x' undeclared"
    std::string mend;     // how to put it right; "" where the driver alone could tell
};

// what() is what the terminal shows; complaints() are the same faults one by one, in order, and never none.
class Error : public std::runtime_error
{
public:
    Error(ExitCode code, const std::string& message); // one complaint, without a place or a mend
    Error(ExitCode code, const std::string& message, std::vector<Complaint> complaints);
    ExitCode code() const;
    const std::vector<Complaint>& complaints() const;

private:
    ExitCode code_;
    std::vector<Complaint> complaints_;
};

// Throws an Error that reads "path:line:column: what: mend"; the mend says how to put it right.
[[noreturn]] void fail(ExitCode code, const SourcePosition& where, std::string_view what,
                       std::string_view mend);

// As above, for faults that have no place in a text: "what: mend".
[[noreturn]] void fail(ExitCode code, std::string_view what, std::string_view mend);

// For several faults at once, whose lines stand in `what`: "what: mend", with the complaints as given.
[[noreturn]] void fail(ExitCode code, std::string_view what, std::string_view mend,
                       std::vector<Complaint> complaints);

// The same fault in other words, which say more of where it arose; its complaints stay as they are.
[[noreturn]] void failAgain(const Error& error, const std::string& message);

} // namespace dioptre
