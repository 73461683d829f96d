#include "render/build.h"

#include <fmt/format.h>

namespace dioptre
{

Program buildProgram(const SourceText& source)
{
    try {
        return buildProgram(flatten(source));
    } catch (const ShaderError& error) {
        std::string text;
        for (const auto& message : error.messages) {
            const auto index = static_cast<std::size_t>(message.line) - 1;
            if (message.line > 0 && index < source.size())
                text += fmt::format("{}:{}: {}\n    {}\n", source[index].file, source[index].line,
                                    message.text, source[index].text);
            else
                text += message.text + "\n";
        }
        fail(ExitCode::badInput, text + "the shader does not compile", "mend the lines named above");
    }
}

} // namespace dioptre
