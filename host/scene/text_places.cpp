#include "scene/text_places.h"

#include <algorithm>

namespace dioptre
{

TextPlaces::TextPlaces(const std::string& text)
    : text_(text), starts_{text.starts_with("\xEF\xBB\xBF") ? 3U : 0U}
{
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1))
        starts_.push_back(at + 1);
    lineBreak_ = starts_.size() > 1 && starts_[1] > 1 && text[starts_[1] - 2] == '\r' ? "\r\n" : "\n";
}

std::size_t TextPlaces::offsetOf(int line, int column) const
{
    const auto continues = [this](std::size_t at) {
        return at < text_.size() && (static_cast<unsigned char>(text_[at]) & 0xC0U) == 0x80U;
    };
    std::size_t at = starts_.at(static_cast<std::size_t>(line) - 1);
    for (int passed = 1; passed < column && at < text_.size(); ++passed)
        for (++at; continues(at); ++at) {
        }
    return at;
}

std::size_t TextPlaces::beginOf(const Value& value) const
{
    return offsetOf(value.where.line, value.where.column);
}

std::size_t TextPlaces::endOf(const Value& value) const
{
    return offsetOf(value.end.line, value.end.column);
}

std::size_t TextPlaces::keyOf(const Entry& entry) const
{
    return offsetOf(entry.where.line, entry.where.column);
}

std::size_t TextPlaces::first() const
{
    return starts_.front();
}

std::size_t TextPlaces::lineStart(std::size_t at) const
{
    return *std::prev(std::ranges::upper_bound(starts_, at));
}

std::size_t TextPlaces::lineEnd(std::size_t at) const
{
    const auto next = std::ranges::upper_bound(starts_, at);
    return next == starts_.end() ? text_.size() : *next;
}

std::string TextPlaces::indentAt(std::size_t at) const
{
    const std::size_t start = lineStart(at);
    return text_.substr(start, text_.find_first_not_of(" \t", start) - start);
}

const std::string& TextPlaces::lineBreak() const
{
    return lineBreak_;
}

} // namespace dioptre
