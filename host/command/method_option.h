// The option --method, which several commands take.
#pragma once

#include <string>

namespace CLI
{
class App;
}

namespace dioptre
{

// Parsing fills `method`, which must live that long; methodNamed() reads it.
void addMethod(CLI::App& command, std::string& method);

// What each method does, for --help: a line each.
std::string methodHelp();

} // namespace dioptre
