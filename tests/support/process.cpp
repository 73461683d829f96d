#include "support/process.h"

#include "base/child_process.h"
#include "base/file.h"

#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <unistd.h>

namespace dioptre::test
{

Outcome run(const std::string& command)
{
    std::string place = "/tmp/dioptre-test-" + std::string(6, 'X'); // mkdtemp's pattern
    if (mkdtemp(place.data()) == nullptr)
        throw std::runtime_error("no temporary folder");
    // A function stands for the program, so that tests read as a user types. What the user's own cache holds
    // must not matter. What is to be sent signals is started as "$PROGRAM".
    const std::string whole = "export DIOPTRE_CACHE=off PROGRAM='" DIOPTRE_PROGRAM
                              "'\ndioptre() { \"$PROGRAM\" \"$@\"; }\n{ " +
                              command + "\n} >'" + place + "/out' 2>'" + place + "/error' </dev/null";
    const auto shell = runChild({"/bin/sh", "-c", whole});
    if (!shell)
        throw std::runtime_error("no shell");
    Outcome outcome;
    outcome.code = shell->signal == 0 ? shell->code : 128 + shell->signal;
    outcome.peak_mib = shell->peak_mib;
    outcome.out = readFile(place + "/out");
    outcome.error = readFile(place + "/error");
    std::filesystem::remove_all(place);
    return outcome;
}

} // namespace dioptre::test
