#include "raster/method.h"

#include "base/error.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <vector>

namespace dioptre
{
namespace
{

// Throws usage.
int facetsFrom(const std::string& text, const std::string& method)
{
    int facets = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), facets);
    if (error != std::errc() || end != text.data() + text.size() || facets < leastFacets ||
        facets > mostFacets)
        fail(ExitCode::usage,
             fmt::format("--method {}: '{}' is no number of facets from {} to {}", method, text, leastFacets,
                         mostFacets),
             fmt::format("write it as in --method {}:{}", method.substr(0, method.find(':')), usualFacets));
    return facets;
}

} // namespace

Method methodNamed(const std::string& text)
{
    const auto colon = text.find(':');
    const std::string name = text.substr(0, colon);
    const auto row = std::ranges::find(shadings, name, &ShadingRow::name);
    if (row == shadings.end()) {
        std::vector<std::string> names;
        for (const auto& known : shadings)
            names.push_back(std::string(known.name) + (known.shading == Shading::trace ? "" : ":N"));
        fail(ExitCode::usage, fmt::format("--method {}: there is no such method", text),
             "the methods are " + join(names, ", "));
    }
    if (row->shading == Shading::trace) {
        if (colon != std::string::npos)
            fail(ExitCode::usage, fmt::format("--method {}: rays are traced to shapes without facets", text),
                 "write --method trace");
        return {};
    }
    return {row->shading,
            colon == std::string::npos ? usualFacets : facetsFrom(text.substr(colon + 1), text)};
}

std::string nameOf(const Method& method)
{
    const auto row = std::ranges::find(shadings, method.shading, &ShadingRow::shading);
    return isRasterised(method) ? fmt::format("{}:{}", row->name, method.facets) : std::string(row->name);
}

} // namespace dioptre
