#include "render/build.h"

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
        for (const auto& message : error.messages) {
            const auto index = static_cast<std::size_t>(message.line) - 1;
            if (message.line > 0 && index < source.size())
                text += fmt::format("{}:{}: {}\n    {}\n", source[index].file, source[index].line,
                                    message.text, source[index].text);
            else
                text += authorFile(source) + ": " + message.text + "\n";
        }
        fail(ExitCode::badInput, text + "the shader does not compile", "mend the lines named above");
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
