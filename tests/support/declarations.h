// What a shader's text declares and uses, read on its own and not by the pruner that tests judge.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace dioptre::test
{

// A declaration at file scope. It starts in the first column, and ends where a line of it ends with ';' or
// '}' in or before that column's bracket.
struct Declaration {
    std::set<std::string> names; // what it declares; a block declares its members
    std::string text;
    bool isFunction = false;
};

std::vector<Declaration> declarationsOf(const std::string& shader);

std::vector<std::string> wordsOf(const std::string& text);

// Functions that main() reaches by calls; `mentioned`: the words of each function.
std::set<std::string> reachedFromMain(const std::map<std::string, std::set<std::string>>& mentioned);

// Names of a shader's declarations that nothing but themselves and receiveShared() mentions; of a block, the
// names of all its members if none is mentioned.
std::set<std::string> unusedNames(const std::string& shader);

} // namespace dioptre::test
