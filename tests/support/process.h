// Running the program itself, as a user or a script would.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace dioptre::test
{

struct Outcome {
    int code = 0;   // exit code; 128 + signal where one ended it
    int signal = 0; // that ended the shell, or what it was replaced by with exec
    std::string out;
    std::string error;
    double peak_mib = 0.0; // of the largest process that it waited for, this one's own until now at least
};

// Runs a shell command with an empty standard input; `dioptre` in it is the program under test, which keeps
// no pictures unless the command sets DIOPTRE_CACHE.
Outcome run(const std::string& command);

// Starts the program alone in a folder, with a shell's words after its name, and sends it the signal as soon
// as `ready` says so of its process. What hangs for a minute is killed.
Outcome runAndSignal(const std::string& folder, const std::string& words, int signal,
                     const std::function<bool(int process)>& ready);

// Whether the process has a handler for the signal.
bool hears(int process, int signal);

} // namespace dioptre::test
