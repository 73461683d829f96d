#include "live/helper.h"

#include "base/heap.h"
#include "gl/context.h"
#include "live/trial_message.h"

#include <csignal>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

// Below the window, whose picture goes on; far enough above nothing that an idle machine notices no
// difference.
constexpr int niceness = 5;

// The window's own kind of context first: drivers keep what they compile by what draws it.
std::unique_ptr<Context> helperContext()
{
    try {
        return makeContext("window");
    } catch (const Error&) {
        return makeContext("auto");
    }
}

// Nothing where there is none: the next message tells why.
std::unique_ptr<Context> contextIfAny()
{
    try {
        return helperContext();
    } catch (const std::exception&) {
        return nullptr;
    }
}

TrialReply answer(const TrialMessage& message)
{
    TrialReply reply{message.number, {}, ""};
    try {
        for (const auto& trial : message.trials) {
            reply.outcomes.push_back(tryProgram(trial, message.drawLimit_s));
            if (!reply.outcomes.back().messages.empty())
                break;
        }
    } catch (const std::exception& error) {
        reply.fault = error.what();
    }
    return reply;
}

} // namespace

int runHelper()
{
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    ::signal(SIGINT, SIG_IGN); // Ctrl-C on the terminal is the window's
    ::signal(SIGPIPE, SIG_IGN);
    ::setpriority(PRIO_PROCESS, 0, niceness);
    keepLargeBlocks();
    startVariablesAtZero();
    std::unique_ptr<Context> context = contextIfAny(); // before the first edit asks for it
    while (const auto message = readTrialMessage(STDIN_FILENO)) {
        TrialReply reply{message->number, {}, ""};
        try {
            if (context == nullptr)
                context = helperContext();
            reply = answer(*message);
        } catch (const std::exception& error) {
            reply.fault = error.what();
        }
        if (!writeAll(STDOUT_FILENO, bytesOf(reply)))
            break;
    }
    return 0;
}

} // namespace dioptre
