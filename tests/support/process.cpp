#include "support/process.h"

#include "base/child_process.h"
#include "base/file.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <future>
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
    outcome.signal = shell->signal;
    outcome.peak_mib = shell->peak_mib;
    outcome.out = readFile(place + "/out");
    outcome.error = readFile(place + "/error");
    std::filesystem::remove_all(place);
    return outcome;
}

Outcome runAndSignal(const std::string& folder, const std::string& words, int signal,
                     const std::function<bool(int)>& ready)
{
    using namespace std::chrono_literals;
    const auto numberFile = std::filesystem::path(folder) / "process";
    // Who started us may have it ignored, as shells have Ctrl-C for what runs in the background.
    const auto before = std::signal(signal, SIG_DFL);
    auto running = std::async(std::launch::async, [&] {
        return run("cd '" + folder + "' && echo $$ >process && exec \"$PROGRAM\" " + words);
    });
    const auto endsWithin = [&](auto time) { return running.wait_for(time) == std::future_status::ready; };
    int process = 0;
    for (int waits = 0; waits < 30000 && !endsWithin(2ms); ++waits) {
        std::ifstream(numberFile) >> process;
        if (process != 0 && ready(process))
            break;
    }
    if (process != 0 && !endsWithin(0ms)) {
        ::kill(process, signal);
        if (!endsWithin(60s))
            ::kill(process, SIGKILL);
    }
    Outcome outcome = running.get();
    std::signal(signal, before);
    std::filesystem::remove(numberFile);
    return outcome;
}

bool hears(int process, int signal)
{
    std::ifstream status("/proc/" + std::to_string(process) + "/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("SigCgt:"))
            return (std::stoull(line.substr(7), nullptr, 16) >> (signal - 1) & 1U) != 0;
    return false;
}

} // namespace dioptre::test
