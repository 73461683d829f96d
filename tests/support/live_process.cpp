#include "support/live_process.h"

#include "base/file.h"
#include "support/x_driver.h"

#include <array>
#include <charconv>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace dioptre::test
{
namespace
{

// What follows the name in /proc/PID/stat, the state first; the name may hold anything. Empty where there is
// no such process.
std::vector<std::string> statOf(pid_t process)
{
    std::ifstream file("/proc/" + std::to_string(process) + "/stat");
    std::string text((std::istreambuf_iterator<char>(file)), {});
    std::istringstream words(text.substr(std::min(text.size(), text.rfind(')') + 1)));
    return {std::istream_iterator<std::string>(words), {}};
}

} // namespace

double cpuOf_s(pid_t process)
{
    const auto stat = statOf(process);
    if (stat.size() < 13)
        return 0.0;
    return (std::stod(stat[11]) + std::stod(stat[12])) / static_cast<double>(::sysconf(_SC_CLK_TCK));
}

bool isRunning(pid_t process)
{
    const auto stat = statOf(process);
    return !stat.empty() && stat[0] != "Z" && stat[0] != "X";
}

LiveProcess::LiveProcess(const std::filesystem::path& folder, const std::vector<std::string>& words,
                         const std::map<std::string, std::string>& environment)
    : errorFile_(folder / "stderr")
{
    std::vector<std::string> command{DIOPTRE_PROGRAM, "live", "--json"};
    command.insert(command.end(), words.begin(), words.end());
    std::vector<char*> arguments;
    for (auto& word : command)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    std::array<int, 2> ends{};
    if (::pipe2(ends.data(), O_CLOEXEC | O_NONBLOCK) != 0 || (process_ = ::fork()) < 0)
        throw std::runtime_error("no process for the window");
    if (process_ == 0) {
        ::prctl(PR_SET_PDEATHSIG, SIGKILL);
        for (const int number : {SIGINT, SIGTERM, SIGPIPE, SIGCHLD}) // who started the test may ignore them
            ::signal(number, SIG_DFL);
        for (const auto& [name, value] : environment)
            ::setenv(name.c_str(), value.c_str(), 1);
        const int error = ::open(errorFile_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
        const int nothing = ::open("/dev/null", O_RDONLY | O_CLOEXEC);
        if (::chdir(folder.c_str()) != 0 || ::dup2(ends[1], STDOUT_FILENO) < 0 ||
            ::dup2(error, STDERR_FILENO) < 0 || ::dup2(nothing, STDIN_FILENO) < 0)
            ::_exit(126);
        ::fcntl(STDOUT_FILENO, F_SETFL, 0); // the reader's end alone is not to wait
        ::execv(arguments[0], arguments.data());
        ::_exit(127);
    }
    ::close(ends[1]);
    output_ = ends[0];
}

LiveProcess::~LiveProcess()
{
    if (!code_) {
        ::kill(process_, SIGKILL);
        ::waitpid(process_, nullptr, 0);
    }
    ::close(output_);
}

void LiveProcess::read()
{
    std::array<char, 4096> buffer{};
    for (ssize_t got = 0; (got = ::read(output_, buffer.data(), buffer.size())) > 0;)
        begun_.append(buffer.data(), static_cast<std::size_t>(got));
    for (std::size_t end = 0; (end = begun_.find('\n')) != std::string::npos; begun_.erase(0, end + 1)) {
        all_ += begun_.substr(0, end + 1);
        heard_.push_back(Json::parse(begun_.substr(0, end)));
    }
    int status = 0;
    if (!code_ && ::waitpid(process_, &status, WNOHANG) == process_)
        code_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

std::optional<LiveProcess::Json> LiveProcess::nextIfThere(const std::string& kind)
{
    for (read(); !heard_.empty();) {
        Json event = std::move(heard_.front());
        heard_.pop_front();
        if (event["event"] == kind)
            return event;
    }
    return std::nullopt;
}

LiveProcess::Json LiveProcess::next(const std::string& kind, double limit_s)
{
    std::optional<Json> event;
    eventually(
        [&] {
            const bool gone = code_.has_value(); // before the last look
            event = nextIfThere(kind);
            return event || gone;
        },
        limit_s);
    if (!event)
        throw std::runtime_error("no event '" + kind + "' came" +
                                 (code_ ? ", the program ended with " + std::to_string(*code_) : "") +
                                 "; it said\n" + all_ + error());
    return *event;
}

void LiveProcess::forget()
{
    read();
    heard_.clear();
}

int LiveProcess::ended(double limit_s)
{
    const auto hasEnded = [this] {
        read();
        return code_.has_value();
    };
    if (!eventually(hasEnded, limit_s)) {
        ::kill(process_, SIGKILL);
        eventually(hasEnded);
    }
    return code_.value_or(-1);
}

void LiveProcess::signal(int number) const
{
    if (!code_)
        ::kill(process_, number);
}

std::vector<pid_t> LiveProcess::children() const
{
    std::vector<pid_t> found;
    std::error_code ignored;
    for (const auto& entry : std::filesystem::directory_iterator("/proc", ignored)) {
        const std::string name = entry.path().filename();
        pid_t number = 0;
        if (std::from_chars(name.data(), name.data() + name.size(), number).ptr != name.data() + name.size())
            continue;
        const auto stat = statOf(number);
        if (stat.size() > 1 && stat[0] != "Z" && stat[1] == std::to_string(process_))
            found.push_back(number);
    }
    return found;
}

double LiveProcess::resident_mib() const
{
    std::ifstream file("/proc/" + std::to_string(process_) + "/statm");
    double whole = 0.0, resident = 0.0;
    file >> whole >> resident;
    return resident * static_cast<double>(::sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}

std::string LiveProcess::error() const
{
    return readFile(errorFile_);
}

} // namespace dioptre::test
