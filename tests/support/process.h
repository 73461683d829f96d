// Running the program itself, as a user or a script would.
#pragma once

#include <string>
#include <vector>

namespace dioptre::test
{

struct Outcome {
    int code = 0; // exit code; 128 + signal where one ended it
    std::string out;
    std::string error;
    double peak_mib = 0.0; // of the largest process that it waited for, this one's own until now at least
};

// Runs a shell command with an empty standard input; `dioptre` in it is the program under test, which keeps
// no pictures unless the command sets DIOPTRE_CACHE.
Outcome run(const std::string& command);

} // namespace dioptre::test
