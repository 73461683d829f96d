#include "command/method_option.h"

#include "raster/method.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace dioptre
{

std::string methodHelp()
{
    std::string text;
    for (const auto& row : shadings)
        text += fmt::format("\n  {} - {}", row.name, row.meaning);
    return text;
}

void addMethod(CLI::App& command, std::string& method)
{
    command
        .add_option("--method", method,
                    fmt::format("how a scene is drawn; of those with facets :N says how many along each side "
                                "of a shape, {} to {}, {} by default:{}",
                                leastFacets, mostFacets, usualFacets, methodHelp()))
        ->type_name("METHOD[:N]")
        ->capture_default_str();
}

} // namespace dioptre
