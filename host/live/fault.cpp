#include "live/fault.h"

#include "base/file.h"

#include <algorithm>
#include <sstream>

namespace dioptre
{
namespace
{

constexpr int linesAround = 2;
constexpr std::size_t mostPlaces = 20; // the first error makes most of the others
constexpr std::size_t mostColumns = 200;

SourceExcerpt excerptOf(const SourcePosition& where)
{
    SourceExcerpt excerpt;
    if (where.path.empty() || where.line == 0)
        return excerpt;
    try {
        std::istringstream text(readFile(where.path));
        excerpt.first = std::max(1, where.line - linesAround);
        std::string line;
        for (int number = 1; number <= where.line + linesAround && std::getline(text, line); ++number) {
            std::erase(line, '\r');
            if (number >= excerpt.first)
                excerpt.lines.push_back(line.substr(0, mostColumns));
        }
    } catch (const Error&) {
        excerpt.lines.clear(); // generated, or gone
    }
    return excerpt;
}

} // namespace

Fault faultOf(const Error& error)
{
    Fault fault{error.what(), {}};
    for (const auto& complaint : error.complaints())
        if (fault.places.size() < mostPlaces)
            fault.places.push_back({complaint, excerptOf(complaint.where)});
    return fault;
}

} // namespace dioptre
