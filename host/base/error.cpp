#include "base/error.h"

#include <fmt/format.h>

namespace dioptre
{

std::string describe(const SourcePosition& where)
{
    if (where.line <= 0)
        return where.path;
    if (where.column <= 0)
        return fmt::format("{}:{}", where.path, where.line);
    return fmt::format("{}:{}:{}", where.path, where.line, where.column);
}

Error::Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}

ExitCode Error::code() const
{
    return code_;
}

void fail(ExitCode code, const SourcePosition& where, std::string_view what, std::string_view mend)
{
    const std::string place = describe(where);
    if (place.empty())
        fail(code, what, mend);
    throw Error(code, fmt::format("{}: {}: {}", place, what, mend));
}

void fail(ExitCode code, std::string_view what, std::string_view mend)
{
    throw Error(code, fmt::format("{}: {}", what, mend));
}

} // namespace dioptre
