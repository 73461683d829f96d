// The other end of a Trier: a process that compiles and draws programs first.
#pragma once

namespace dioptre
{

// The one argument that makes this program a helper.
inline constexpr const char* helperWord = "--try-programs";

// Reads messages from standard input and answers on standard output until the input ends. Runs at low
// priority. Gives what the process ends with.
int runHelper();

} // namespace dioptre
