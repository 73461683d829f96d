// A backend tried in a process of its own, so that a driver that crashes or hangs is a finding and not the
// end.
#pragma once

#include "gl/context.h"

namespace dioptre
{

struct BackendReport {
    ContextInfo info;  // its backend is set in any case, the rest where it worked
    std::string fault; // "" where it worked
    std::string mend = packagesForOpenGl;
    bool absent = false;       // nothing is broken: the machine, as it is set up, does not have it
    bool endedProcess = false; // the driver crashed or hung: trying it is the end of any process
    double start_ms = 0.0;     // from nothing, the driver's loading included, to a context that is current
};

// Tries one of the single backends. To be called before this process makes a context of its own: a driver's
// threads do not live on in a child.
BackendReport tryBackend(const std::string& backend);

} // namespace dioptre
