#include "render/source_text.h"

#include "base/file.h"

#include <cctype>

namespace dioptre
{
namespace
{

bool startsIdentifier(char c)
{
    return std::isalpha(static_cast<unsigned char>(c)) != 0 || c == '_';
}

bool continuesIdentifier(char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

} // namespace

SourceText linesOf(std::string_view text, const std::string& file)
{
    if (text.starts_with("\xEF\xBB\xBF"))
        text.remove_prefix(3);
    SourceText lines;
    int number = 1;
    while (!text.empty()) {
        const auto end = text.find_first_of("\r\n");
        lines.push_back({std::string(text.substr(0, end)), file, number++});
        if (end == std::string_view::npos)
            break;
        text.remove_prefix(text.substr(end).starts_with("\r\n") ? end + 2 : end + 1);
    }
    return lines;
}

SourceText readSource(const std::filesystem::path& path)
{
    SourceText lines = linesOf(readFile(path), path.string());
    for (const auto& line : lines)
        if (const auto at = line.text.find('\0'); at != std::string::npos)
            fail(ExitCode::badInput, {line.file, line.line, static_cast<int>(at) + 1},
                 "a byte of 0 stands here, and a shader is text", "save it as text, in UTF-8");
    return lines;
}

std::string flatten(const SourceText& source)
{
    std::string text;
    for (const auto& line : source)
        text += line.text + '\n';
    return text;
}

std::string flattenWithoutComments(const SourceText& source)
{
    std::string text;
    bool inComment = false;
    for (const auto& line : source) {
        for (std::size_t i = 0; i < line.text.size(); ++i) {
            const std::string_view rest = std::string_view(line.text).substr(i);
            if (inComment ? rest.starts_with("*/") : rest.starts_with("/*")) {
                inComment = !inComment;
                text += inComment ? " " : "";
                ++i;
            } else if (!inComment && rest.starts_with("//")) {
                break;
            } else if (!inComment) {
                text += line.text[i];
            }
        }
        while (text.ends_with(' ') || text.ends_with('\t'))
            text.pop_back();
        text += '\n';
    }
    return text;
}

std::vector<std::string_view> identifiers(std::string_view line, bool& inComment)
{
    std::vector<std::string_view> found;
    std::size_t i = 0;
    while (i < line.size()) {
        if (inComment) {
            const auto end = line.find("*/", i);
            if (end == std::string_view::npos)
                return found;
            inComment = false;
            i = end + 2;
        } else if (line.substr(i).starts_with("//")) {
            return found;
        } else if (line.substr(i).starts_with("/*")) {
            inComment = true;
            i += 2;
        } else if (startsIdentifier(line[i])) {
            const auto begin = i;
            while (i < line.size() && continuesIdentifier(line[i]))
                ++i;
            found.push_back(line.substr(begin, i - begin));
        } else if (std::isdigit(static_cast<unsigned char>(line[i])) != 0) {
            while (i < line.size() && continuesIdentifier(line[i])) // 1e30, 0x1F, 2u
                ++i;
        } else {
            ++i;
        }
    }
    return found;
}

} // namespace dioptre
