// An X server without a screen, for tests that need a window.
#pragma once

#include <array>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

namespace dioptre::test
{

// Starts Xvfb under a display number that is free, and ends it. Throws where there is no Xvfb: a test that
// needs one fails without it.
class VirtualDisplay
{
public:
    explicit VirtualDisplay(const std::vector<std::string>& options = {})
    {
        std::array<int, 2> ends{};
        if (::pipe(ends.data()) != 0 || (server_ = ::fork()) < 0)
            throw std::runtime_error("no process for Xvfb");
        if (server_ == 0)
            become(ends[1], options);
        ::close(ends[1]);
        for (char digit = 0; ::read(ends[0], &digit, 1) == 1 && digit != '\n';)
            name_ += digit; // what Xvfb says once it is ready
        ::close(ends[0]);
        if (name_ == ":") {
            end();
            throw std::runtime_error("Xvfb does not start: is the package xvfb installed?");
        }
    }
    VirtualDisplay(const VirtualDisplay&) = delete;
    VirtualDisplay& operator=(const VirtualDisplay&) = delete;
    ~VirtualDisplay()
    {
        end();
    }

    // What DISPLAY is to be.
    const std::string& name() const
    {
        return name_;
    }

private:
    [[noreturn]] static void become(int readyEnd, const std::vector<std::string>& options)
    {
        ::prctl(PR_SET_PDEATHSIG, SIGTERM); // a test that crashes leaves no server
        const std::string ready = std::to_string(readyEnd);
        // A server that resets with its last client's end may refuse the next one.
        std::vector<const char*> words{"Xvfb", "-displayfd", ready.c_str(), "-noreset"};
        for (const std::string& option : options)
            words.push_back(option.c_str());
        words.push_back(nullptr);
        ::execvp(words[0], const_cast<char* const*>(words.data()));
        ::_exit(127);
    }

    void end() const
    {
        ::kill(server_, SIGTERM);
        ::waitpid(server_, nullptr, 0);
    }

    pid_t server_ = -1;
    std::string name_ = ":";
};

} // namespace dioptre::test
