// The option --include, which several commands take.
#pragma once

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace dioptre
{

// Parsing fills `folders`, which must live that long.
void addInclude(CLI::App& command, std::vector<std::string>& folders);

} // namespace dioptre
