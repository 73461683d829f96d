// Lines and columns of a text as offsets into it.
#pragma once

#include "scene/document.h"

#include <string>
#include <vector>

namespace dioptre
{

// Of one text, which must outlive it: columns count code points from 1, as the TOML library has them.
class TextPlaces
{
public:
    explicit TextPlaces(const std::string& text);

    std::size_t offsetOf(int line, int column) const;
    std::size_t beginOf(const Value& value) const;
    std::size_t endOf(const Value& value) const;
    std::size_t keyOf(const Entry& entry) const;

    std::size_t first() const;                   // behind the byte-order mark
    std::size_t lineStart(std::size_t at) const; // of the line that holds the offset
    std::size_t lineEnd(std::size_t at) const;   // behind its end of line
    std::string indentAt(std::size_t at) const;  // the blanks that its line begins with
    const std::string& lineBreak() const;        // the text's own: "\n" or "\r\n"

private:
    const std::string& text_;
    std::vector<std::size_t> starts_; // of the lines
    std::string lineBreak_;
};

} // namespace dioptre
