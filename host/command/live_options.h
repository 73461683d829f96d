// The words of `dioptre live`.
#pragma once

#include "command/command.h"

namespace CLI
{
class App;
}

namespace dioptre
{

void addLive(CLI::App& app, LiveOptions& options);

} // namespace dioptre
