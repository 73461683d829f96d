#include "stability/batch_csv.h"

#include "base/error.h"
#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>

namespace dioptre
{
namespace
{

constexpr std::array columnNames = {"case", "id", "prim", "p0", "p1", "p2", "p3", "p4", "p5",   "p6",
                                    "p7",   "p8", "ox",   "oy", "oz", "dx", "dy", "dz", "tmin", "spawn"};
enum Column : std::size_t {
    caseColumn,
    idColumn,
    primColumn,
    firstP,
    originColumn = 12,
    directionColumn = 15,
    tMinColumn = 18,
    spawnColumn = 19
};

struct Field {
    std::string_view text;
    int column = 1; // of the line, from 1
};

std::vector<Field> fieldsOf(std::string_view line)
{
    std::vector<Field> fields;
    for (std::size_t start = 0;;) {
        const std::size_t end = std::min(line.find(',', start), line.size());
        std::string_view text = line.substr(start, end - start);
        int column = static_cast<int>(start) + 1;
        while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) {
            text.remove_prefix(1);
            ++column;
        }
        while (!text.empty() && (text.back() == ' ' || text.back() == '\t' || text.back() == '\r'))
            text.remove_suffix(1);
        fields.push_back({text, column});
        if (end == line.size())
            return fields;
        start = end + 1;
    }
}

// Reads lines under a heading that says which column is which.
class BatchReader
{
public:
    BatchReader(std::string path, std::string_view heading) : path_(std::move(path))
    {
        const auto fields = fieldsOf(heading);
        width_ = fields.size();
        for (std::size_t i = 0; i < columnNames.size(); ++i) {
            const auto found = std::ranges::find(fields, std::string_view(columnNames[i]), &Field::text);
            if (found == fields.end())
                fail(ExitCode::badInput, SourcePosition{path_, 1, 1},
                     fmt::format("no column is called {}", columnNames[i]),
                     fmt::format("begin with a line of names: {}", fmt::join(columnNames, ",")));
            place_[i] = static_cast<std::size_t>(found - fields.begin());
        }
    }

    RayProblem problem(std::string_view text, int line)
    {
        line_ = line;
        fields_ = fieldsOf(text);
        if (fields_.size() != width_)
            fail(ExitCode::badInput, SourcePosition{path_, line, 1},
                 fmt::format("{} fields stand under {} names", fields_.size(), width_),
                 "give each column of the first line one field");
        RayProblem problem;
        problem.caseName = field(caseColumn).text;
        problem.id = field(idColumn).text;
        problem.primitive = whole(primColumn, shapeTriangle,
                                  "0 sphere, 1 open and 2 capped cylinder, 3 plane, "
                                  "4 disk, 5 rectangle, 6 triangle");
        for (std::size_t i = 0; i < problem.p.size(); ++i)
            problem.p[i] = number(firstP + i);
        problem.origin = {number(originColumn), number(originColumn + 1), number(originColumn + 2)};
        problem.direction = {number(directionColumn), number(directionColumn + 1),
                             number(directionColumn + 2)};
        problem.tMin = number(tMinColumn);
        problem.spawn = whole(spawnColumn, 1, "1 where the origin lies on the surface, else 0") == 1;
        return problem;
    }

private:
    const Field& field(std::size_t column) const
    {
        return fields_[place_[column]];
    }

    [[noreturn]] void refuse(std::size_t column, const std::string& mend) const
    {
        const Field& wrong = field(column);
        fail(ExitCode::badInput, SourcePosition{path_, line_, wrong.column},
             fmt::format("{}: \"{}\" will not do", columnNames[column], wrong.text), mend);
    }

    // "inf" and "nan" are numbers: what a kernel makes of them is worth asking.
    double number(std::size_t column) const
    {
        std::string_view text = field(column).text;
        if (text.starts_with('+'))
            text.remove_prefix(1);
        double value = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error == std::errc::result_out_of_range || error != std::errc() ||
            end != text.data() + text.size())
            refuse(column, "write a number");
        return value;
    }

    int whole(std::size_t column, int most, const std::string& meaning) const
    {
        const double value = number(column);
        if (!(value >= 0.0 && value <= most && value == std::floor(value)))
            refuse(column, "it is " + meaning);
        return static_cast<int>(value);
    }

    std::string path_;
    std::size_t width_ = 0;
    std::array<std::size_t, columnNames.size()> place_{};
    std::vector<Field> fields_;
    int line_ = 1;
};

} // namespace

std::vector<RayProblem> readBatch(const std::string& text, const std::string& path)
{
    std::vector<RayProblem> problems;
    std::optional<BatchReader> reader;
    int line = 0;
    for (std::size_t start = 0; start < text.size();) {
        const std::size_t end = std::min(text.find('\n', start), text.size());
        const std::string_view row(text.data() + start, end - start);
        ++line;
        start = end + 1;
        if (!reader)
            reader.emplace(path, row.starts_with("\xEF\xBB\xBF") ? row.substr(3) : row);
        else if (row.find_first_not_of(" \t\r") != std::string_view::npos)
            problems.push_back(reader->problem(row, line));
    }
    if (!reader)
        BatchReader(path, ""); // tells what is missing
    return problems;
}

std::string batchText(std::span<const RayProblem> problems, std::span<const DeviceAnswer> answers)
{
    std::string text = "case,id,hit,t,px,py,pz,nx,ny,nz\n";
    for (std::size_t i = 0; i < problems.size(); ++i) {
        const RayProblem& problem = problems[i];
        const DeviceAnswer& answer = answers[i];
        const glm::dvec3 point = answer.hit ? problem.origin + answer.t * problem.direction : glm::dvec3(0.0);
        const double size = glm::length(answer.normal);
        const glm::dvec3 normal = answer.hit && size > 0.0 ? answer.normal / size : glm::dvec3(0.0);
        text += fmt::format("{},{},{},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g}\n", problem.caseName,
                            problem.id, answer.hit ? 1 : 0, answer.hit ? answer.t : 0.0, point.x, point.y,
                            point.z, normal.x, normal.y, normal.z);
    }
    return text;
}

} // namespace dioptre
