// Standard input, output and error as the caller left them: closed, or full.
#pragma once

namespace dioptre
{

// First of all: a stream that is closed would give its number to the next file that is opened, and what is
// printed would end up in there. A closed output takes nothing from then on, and says so.
void holdStandardStreams();

// Last of all: whether everything that was printed has been taken.
bool standardOutputTaken();

} // namespace dioptre
