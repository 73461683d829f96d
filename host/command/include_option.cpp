#include "command/include_option.h"

#include <CLI/CLI.hpp>

namespace dioptre
{

void addInclude(CLI::App& command, std::vector<std::string>& folders)
{
    command
        .add_option("--include", folders,
                    "a folder that pictures and #include may come from, besides that of the scene or shader; "
                    "may be repeated")
        ->type_name("FOLDER")
        ->check(CLI::ExistingDirectory)
        ->allow_extra_args(false);
}

} // namespace dioptre
