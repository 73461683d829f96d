// The commands of the program with windows.
#pragma once

#include "command/command.h"

namespace dioptre
{

// Shows an input in a window until it is closed. Throws noOpenGl without a display, and what the input's
// first picture fails with.
ExitCode live(const LiveOptions& options);

// Measures how long an edit takes to reach the window.
ExitCode benchReload(const ReloadBenchOptions& options);

} // namespace dioptre
