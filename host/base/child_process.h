// Running another program and hearing how it went.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace dioptre
{

struct ChildOutcome {
    int code = 0;   // exit code; meaningless where a signal ended it
    int signal = 0; // that ended it; 0 for none
    std::string out;
    std::string error;
    // Largest resident size. The kernel lets a child inherit its parent's peak, so this is never below the
    // peak of the process that asks.
    double peak_mib = 0.0;
};

// Runs command[0], looked up in PATH, with an empty standard input and `environment` added to ours. Gives
// nothing where it cannot be started.
std::optional<ChildOutcome> runChild(const std::vector<std::string>& command,
                                     const std::map<std::string, std::string>& environment = {});

// Whether a child has ended and nobody has waited for it yet; it is left so.
bool hasEnded(pid_t child);

} // namespace dioptre
