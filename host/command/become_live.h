// Commands that need a window are another program's, which is linked with the window's libraries.
#pragma once

#include "base/error.h"

namespace dioptre
{

// Goes on as `dioptre-live`, which lies beside this program, with the same arguments. Throws noOpenGl where
// it was not built.
[[noreturn]] ExitCode becomeLive(char** arguments);

} // namespace dioptre
