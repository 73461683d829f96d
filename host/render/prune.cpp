#include "render/prune.h"

#include <algorithm>
#include <map>

namespace dioptre
{
namespace
{

bool isBlank(const std::string& line)
{
    return line.find_first_not_of(" \t") == std::string::npos;
}

bool isComment(const std::string& line)
{
    const auto begin = line.find_first_not_of(" \t");
    return begin != std::string::npos && line.compare(begin, 2, "//") == 0;
}

// The line without its // comment.
std::string_view code(const std::string& line)
{
    return std::string_view(line).substr(0, line.find("//"));
}

// Where the declaration that begins at `i` ends: at the ';' or '}' outside all braces, or at a directive's
// last line.
std::size_t endOfDeclaration(const SourceText& source, std::size_t i)
{
    const bool directive = code(source[i].text).find_first_not_of(" \t") == source[i].text.find('#');
    const SourcePosition start{source[i].file, source[i].line, 0};
    int depth = 0;
    for (; i < source.size(); ++i) {
        const auto line = code(source[i].text);
        if (directive) {
            if (!line.ends_with('\\'))
                return i + 1;
            continue;
        }
        bool ends = false;
        for (const char c : line) {
            if (c == ' ' || c == '\t')
                continue;
            depth += c == '{' || c == '(' ? 1 : c == '}' || c == ')' ? -1 : 0;
            ends = depth == 0 && (c == ';' || c == '}');
        }
        if (ends)
            return i + 1;
    }
    fail(ExitCode::badInput, start, "this declaration never ends",
         "close its brackets, or end it with a semicolon");
}

void classify(ShaderItem& item, const SourceText& source)
{
    std::vector<std::string> words;
    std::vector<std::string> members; // second word of each line within braces: "vec4 u_index[…];"
    bool inComment = false;
    bool inBraces = false;
    std::string all;
    for (auto i = item.first; i < item.last; ++i) {
        const auto found = identifiers(source[i].text, inComment);
        words.insert(words.end(), found.begin(), found.end());
        if (found.size() >= 2 && inBraces)
            members.emplace_back(found[1]);
        inBraces = inBraces || code(source[i].text).find('{') != std::string_view::npos;
        all += std::string(code(source[i].text)) + ' ';
    }
    item.references = {words.begin(), words.end()};
    const auto first = all.find_first_not_of(" \t");
    const auto word = [&](std::size_t i) { return i < words.size() ? words[i] : std::string(); };
    const auto declare = [&](ShaderItem::Kind kind, const std::string& name) {
        item.kind = kind;
        item.names = {name};
    };
    if (first == std::string::npos)
        item.kind = ShaderItem::Kind::heading;
    else if (all[first] == '#')
        word(0) == "define" ? declare(ShaderItem::Kind::macro, word(1))
                            : void(item.kind = ShaderItem::Kind::other);
    else if (word(0) == "struct")
        declare(ShaderItem::Kind::structure, word(1));
    else if (word(0) == "layout" && std::find(words.begin(), words.end(), "uniform") != words.end()) {
        const auto name = std::find(words.begin(), words.end(), "uniform") + 1;
        declare(ShaderItem::Kind::block, name != words.end() ? *name : "");
        item.names.insert(members.begin(), members.end());
    } else if (word(0) == "layout") // an input of the vertex stage
        declare(ShaderItem::Kind::uniform, words.back());
    else if (word(0) == "uniform" || word(0) == "in")
        declare(ShaderItem::Kind::uniform, word(2));
    else if (word(0) == "const")
        declare(ShaderItem::Kind::constant, word(2));
    else if (word(0) == "out")
        declare(ShaderItem::Kind::output, word(2));
    else if (word(0) == "flat")
        declare(word(1) == "out" ? ShaderItem::Kind::output : ShaderItem::Kind::uniform, word(3));
    else if (all.find('(') != std::string::npos)
        declare(ShaderItem::Kind::function, word(1));
    else if (words.size() >= 2) // a global variable, fed like a uniform
        declare(ShaderItem::Kind::uniform, word(1));
}

} // namespace

std::vector<ShaderItem> itemsOf(const SourceText& source)
{
    std::vector<ShaderItem> items;
    std::size_t i = 0;
    while (i < source.size()) {
        if (isBlank(source[i].text)) {
            ++i;
            continue;
        }
        ShaderItem item;
        item.first = i;
        while (i < source.size() && isComment(source[i].text))
            ++i;
        // The declaration goes on over the last comment of the block above it only if no blank line parts
        // them.
        if (i < source.size() && !isBlank(source[i].text))
            i = endOfDeclaration(source, i);
        item.last = i;
        classify(item, source);
        items.push_back(item);
    }
    return items;
}

SourceText prune(const SourceText& source)
{
    const auto items = itemsOf(source);
    std::multimap<std::string, std::size_t> declarations;
    for (std::size_t i = 0; i < items.size(); ++i)
        for (const auto& name : items[i].names)
            declarations.emplace(name, i);

    std::set<std::size_t> kept;
    std::vector<std::size_t> open;
    const auto keep = [&](std::size_t i) {
        if (kept.insert(i).second)
            open.push_back(i);
    };
    for (std::size_t i = 0; i < items.size(); ++i)
        if (items[i].kind == ShaderItem::Kind::output || items[i].kind == ShaderItem::Kind::other ||
            items[i].names.contains("main"))
            keep(i);
    while (!open.empty()) {
        const auto item = open.back();
        open.pop_back();
        for (const auto& name : items[item].references)
            for (auto [at, end] = declarations.equal_range(name); at != end; ++at)
                keep(at->second);
    }

    std::set<std::string> files; // that still hold something
    for (const auto i : kept)
        files.insert(source[items[i].last - 1].file);
    SourceText result;
    for (std::size_t i = 0; i < items.size(); ++i) {
        const auto& item = items[i];
        const bool heading =
            item.kind == ShaderItem::Kind::heading && files.contains(source[item.first].file);
        if (!kept.contains(i) && !heading)
            continue;
        if (!result.empty() && item.kind != ShaderItem::Kind::uniform &&
            item.kind != ShaderItem::Kind::constant && item.kind != ShaderItem::Kind::macro)
            result.push_back({"", source[item.first].file, source[item.first].line});
        result.insert(result.end(), source.begin() + static_cast<std::ptrdiff_t>(item.first),
                      source.begin() + static_cast<std::ptrdiff_t>(item.last));
    }
    return result;
}

} // namespace dioptre
