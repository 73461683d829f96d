#include "live/excerpt_line.h"

namespace dioptre
{
namespace
{

constexpr int tabStop = 4;

bool continuesLetter(char byte)
{
    return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U;
}

} // namespace

ShownLine shownLine(std::string_view line, int column, ColumnUnit unit)
{
    ShownLine shown;
    int letters = 0; // shown
    int counted = 0; // columns
    int start = 0;   // letters before the one that the last byte belongs to
    for (const char byte : line) {
        const bool continues = continuesLetter(byte);
        counted += unit == ColumnUnit::bytes || !continues ? 1 : 0;
        if (!continues)
            start = letters;
        if (counted == column && shown.caret < 0)
            shown.caret = start;
        if (byte == '\t') {
            const int blanks = tabStop - letters % tabStop;
            shown.text.append(static_cast<std::size_t>(blanks), ' ');
            letters += blanks;
            continue;
        }
        shown.text += byte;
        letters += continues ? 0 : 1;
    }
    if (column > 0 && shown.caret < 0)
        shown.caret = letters;
    return shown;
}

} // namespace dioptre
