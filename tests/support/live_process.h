// `dioptre live --json` as a process beside the test: its events, its end, what it uses.
#pragma once

#include <nlohmann/json.hpp>

#include <deque>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <sys/types.h>
#include <vector>

namespace dioptre::test
{

// Ends with the test, whatever the test's end; nothing it waits for takes for ever.
class LiveProcess
{
public:
    using Json = nlohmann::json;

    // `dioptre live --json` and the words, run in the folder with `environment` added to the test's. Its
    // standard error goes to the file "stderr" there.
    LiveProcess(const std::filesystem::path& folder, const std::vector<std::string>& words,
                const std::map<std::string, std::string>& environment);
    LiveProcess(const LiveProcess&) = delete;
    LiveProcess& operator=(const LiveProcess&) = delete;
    ~LiveProcess();

    // The next event of that kind; those before it are passed over. Throws, with all that was said, where
    // none comes within `limit_s` or the program ends before.
    Json next(const std::string& kind, double limit_s = 60.0);

    // The same, without waiting.
    std::optional<Json> nextIfThere(const std::string& kind);

    // Passes over what was said so far.
    void forget();

    // Exit code, or 128 + the signal that ended it. What does not end by itself within `limit_s` is killed,
    // which gives 128 + SIGKILL.
    int ended(double limit_s = 30.0);
    void signal(int number) const;

    pid_t id() const
    {
        return process_;
    }
    std::vector<pid_t> children() const;
    double resident_mib() const;
    std::string error() const;

private:
    void read();

    pid_t process_ = -1;
    int output_ = -1;
    std::filesystem::path errorFile_;
    std::string begun_;      // of a line
    std::deque<Json> heard_; // and not asked for yet
    std::string all_;        // that was ever said
    std::optional<int> code_;
};

// Of the process, both modes, since its start.
double cpuOf_s(pid_t process);

bool isRunning(pid_t process);

} // namespace dioptre::test
