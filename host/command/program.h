// What main() of both programs is: the only place where an Error becomes a message and an exit code.
#pragma once

#include "command/command.h"

namespace dioptre
{

// Gives what the process ends with.
int runProgram(int count, char** arguments, const WindowCommands& windows);

} // namespace dioptre
