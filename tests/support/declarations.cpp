#include "support/declarations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <sstream>

namespace dioptre::test
{

std::vector<std::string> wordsOf(const std::string& text)
{
    std::vector<std::string> words;
    bool within = false;
    for (const char c : text) {
        const bool isWord = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        if (isWord && !within)
            words.emplace_back();
        if (isWord)
            words.back() += c;
        within = isWord;
    }
    return words;
}

namespace
{

// The lines without their comments.
std::vector<std::string> codeLines(const std::string& shader)
{
    std::vector<std::string> lines;
    std::istringstream stream(shader);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line.substr(0, line.find("//")));
    return lines;
}

Declaration declarationOf(const std::string& text)
{
    Declaration result{{}, text, false};
    const auto words = wordsOf(text);
    const auto bracket = text.find_first_of("({");
    if (text.starts_with("layout")) {
        std::istringstream members(text.substr(text.find('{')));
        for (std::string line; std::getline(members, line);)
            if (const auto found = wordsOf(line); found.size() >= 2)
                result.names.insert(found[1]);
        return result;
    }
    static const std::set<std::string> qualifiers = {"uniform", "const", "out", "in", "flat"};
    std::size_t name = text.starts_with("#define") || text.starts_with("struct") ? 1 : 0;
    while (qualifiers.contains(words[name]))
        ++name;
    name += text.starts_with("#define") || text.starts_with("struct") ? 0 : 1;
    result.names = {words[name]};
    result.isFunction = bracket != std::string::npos && text[bracket] == '(' && text.ends_with("}\n");
    return result;
}

} // namespace

std::vector<Declaration> declarationsOf(const std::string& shader)
{
    std::vector<Declaration> declarations;
    std::string text;
    for (const auto& line : codeLines(shader)) {
        const bool blank = line.find_first_not_of(' ') == std::string::npos;
        if (blank || line.starts_with("#version"))
            continue;
        text += line + '\n';
        const auto last = line[line.find_last_not_of(' ')];
        const bool open = text.find('{') != std::string::npos && !line.starts_with('}');
        if (line.starts_with('#') || (!open && (last == ';' || last == '}'))) {
            declarations.push_back(declarationOf(text));
            text.clear();
        }
    }
    EXPECT_EQ(text, "") << "the last declaration does not end";
    return declarations;
}

std::set<std::string> reachedFromMain(const std::map<std::string, std::set<std::string>>& mentioned)
{
    std::set<std::string> reached = {"main"};
    std::vector<std::string> open = {"main"};
    while (!open.empty()) {
        const auto names = mentioned.at(open.back());
        open.pop_back();
        for (const auto& name : names)
            if (mentioned.contains(name) && reached.insert(name).second)
                open.push_back(name);
    }
    return reached;
}

std::set<std::string> unusedNames(const std::string& shader)
{
    const auto declarations = declarationsOf(shader);
    std::map<std::string, int> mentions; // declarations that hold the name
    for (const auto& declaration : declarations) {
        const auto words = wordsOf(declaration.text);
        const bool receives = declaration.names.contains("receiveShared");
        for (const auto& word : std::set<std::string>(words.begin(), words.end()))
            mentions[word] += receives && word != "v_shared" && word != "receiveShared" ? 0 : 1;
    }
    std::set<std::string> unused;
    for (const auto& declaration : declarations) {
        const bool output = declaration.text.starts_with("out ") || declaration.text.starts_with("flat out ");
        const auto& names = declaration.names;
        if (!output && !names.contains("main") &&
            std::ranges::none_of(names, [&](const auto& name) { return mentions[name] > 1; }))
            unused.insert(names.begin(), names.end());
    }
    return unused;
}

} // namespace dioptre::test
