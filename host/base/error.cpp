#include "base/error.h"

#include <fmt/format.h>

#include <utility>

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

Error::Error(ExitCode code, const std::string& message) : Error(code, message, {{{}, message, ""}}) {}

Error::Error(ExitCode code, const std::string& message, std::vector<Complaint> complaints)
    : std::runtime_error(message), code_(code), complaints_(std::move(complaints))
{
}

ExitCode Error::code() const
{
    return code_;
}

const std::vector<Complaint>& Error::complaints() const
{
    return complaints_;
}

void fail(ExitCode code, const SourcePosition& where, std::string_view what, std::string_view mend)
{
    const std::string place = describe(where);
    throw Error(code, fmt::format("{}{}{}: {}", place, place.empty() ? "" : ": ", what, mend),
                {{where, std::string(what), std::string(mend)}});
}

void fail(ExitCode code, std::string_view what, std::string_view mend)
{
    fail(code, SourcePosition{}, what, mend);
}

void fail(ExitCode code, std::string_view what, std::string_view mend, std::vector<Complaint> complaints)
{
    throw Error(code, fmt::format("{}: {}", what, mend), std::move(complaints));
}

void failAgain(const Error& error, const std::string& message)
{
    throw Error(error.code(), message, error.complaints());
}

} // namespace dioptre
