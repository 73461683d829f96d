// Another program that is fed through its standard input.
#pragma once

#include "base/child_process.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dioptre
{

class FedChild
{
public:
    // Starts command[0], looked up in PATH; nothing where it cannot be started. It is in a process group of
    // its own: Ctrl-C on the terminal reaches us alone. Until it ends SIGPIPE is ignored.
    static std::unique_ptr<FedChild> start(const std::vector<std::string>& command);

    FedChild(const FedChild&) = delete;
    FedChild& operator=(const FedChild&) = delete;
    // A child that was not waited for is killed.
    ~FedChild();

    // Gives it all bytes; false where it reads no more. Throws retry where an Interruption was noted
    // meanwhile.
    bool write(std::span<const std::uint8_t> bytes);

    // Ends its input and waits. What it printed, on either stream, is in `error`.
    ChildOutcome finish();

    // Whether finish() need not wait.
    bool hasEnded() const;

    // Asks it to end in good order, as Ctrl-C would.
    void interrupt() const;

private:
    FedChild(int process, int input, int printed);
    void closeInput();

    int process_;
    int input_;   // the pipe that it reads
    int printed_; // a file in memory
    void (*pipeHandler_)(int);
};

} // namespace dioptre
