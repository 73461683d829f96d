#include "render/build.h"

#include "render/author_column.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace dioptre
{

namespace
{

// Whose text it is at last, for messages without a line, as linkers write them.
std::string authorFile(const SourceText& source)
{
    const auto written = std::find_if(source.rbegin(), source.rend(),
                                      [](const SourceLine& line) { return line.file != "generated"; });
    return written == source.rend() ? "generated" : written->file;
}

// Runs `build` and leads the driver's messages back to the lines of the stage that they speak of.
Program mapped(const SourceText& fragment, const SourceText& vertex, const std::function<Program()>& build)
{
    try {
        return build();
    } catch (const ShaderError& error) {
        const SourceText& source = error.inVertexStage ? vertex : fragment;
        std::string text;
        std::vector<Complaint> complaints;
        for (const auto& message : error.messages) {
            const auto index = static_cast<std::size_t>(message.line) - 1;
            const SourceLine* line = message.line > 0 && index < source.size() ? &source[index] : nullptr;
            const SourcePosition where =
                line ? SourcePosition{line->file, line->line, authorColumn(message, source, index)}
                     : SourcePosition{authorFile(source)};
            complaints.push_back({where, message.text, ""});
            text += fmt::format("{}: {}\n", describe(where), message.text);
            if (line)
                text += fmt::format("    {}\n", line->text);
        }
        fail(ExitCode::badInput, text + "the shader does not compile", "mend the lines named above",
             std::move(complaints));
    }
}

} // namespace

Program buildProgram(const SourceText& fragment, const SourceText& vertex)
{
    return mapped(fragment, vertex, [&] { return buildProgram(flatten(fragment), flatten(vertex)); });
}

Program buildProgram(const SourceText& fragment)
{
    return mapped(fragment, {}, [&] { return buildProgram(flatten(fragment)); });
}

} // namespace dioptre
