#include "render/build.h"

#include "render/author_column.h"

#include <fmt/format.h>

#include <algorithm>

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

} // namespace

void failToBuild(const ShaderError& error, const SourceText& fragment, const SourceText& vertex)
{
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

Program buildProgram(const SourceText& fragment, const SourceText& vertex)
{
    try {
        return buildProgram(flatten(fragment), flatten(vertex));
    } catch (const ShaderError& error) {
        failToBuild(error, fragment, vertex);
    }
}

Program buildProgram(const SourceText& fragment)
{
    try {
        return buildProgram(flatten(fragment));
    } catch (const ShaderError& error) {
        failToBuild(error, fragment, {});
    }
}

} // namespace dioptre
