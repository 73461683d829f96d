#include "live/live.h"

#include "base/interruption.h"
#include "live/session.h"

namespace dioptre
{

ExitCode live(const LiveOptions& options)
{
    startVariablesAtZero();
    const Interruption interruption;
    Session session(options);
    while (session.turn()) {
    }
    return ExitCode::done;
}

} // namespace dioptre
