#include "live/live.h"

#include "base/interruption.h"
#include "live/session.h"

namespace dioptre
{

ExitCode live(const LiveOptions& options)
{
    refuseBadMethods(options, findLiveInput(options.input));
    startVariablesAtZero();
    int signal = 0;
    {
        const Interruption interruption;
        Session session(options);
        while (session.turn()) {
        }
        signal = Interruption::signal();
    }
    if (signal != 0)
        endBySignal(signal);
    return ExitCode::done;
}

} // namespace dioptre
