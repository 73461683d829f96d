#include "base/contact_sheet.h"

#include "base/lettering.h"

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr Colour8 background = {32, 32, 32};
constexpr Colour8 emptyCell = {44, 44, 44};
constexpr Colour8 bright = {232, 232, 232};
constexpr Colour8 dim = {176, 176, 176};

// In sizes of the text.
constexpr int widestColumnText = 22; // a picture whose text is neither at its least nor at its largest
constexpr int widestRowText = 44;    // heading and caption, where the columns leave less place than that
constexpr int scaleWidth = 8;

// Places on the sheet, in pixels but for the counts. They count from the top, as a sheet is read.
struct Layout {
    int margin = 0; // around all, and between columns
    int gap = 0;    // between a picture and a text
    int line = 0;   // height of a line of text
    int headingHeight = 0;
    int columnWidth = 0;
    int pictureHeight = 0;
    int differenceWidth = 0;
    int differenceHeight = 0; // 0 where there are none
    int lineCount = 0;
    int across = 0; // columns beside each other
    int rows = 0;
    int width = 0; // of the sheet

    int linesTop() const // from a column's top, as the next ones
    {
        return line + gap + pictureHeight + gap;
    }
    int captionTop() const
    {
        return linesTop() + lineCount * line + margin / 2;
    }
    int columnHeight() const
    {
        return differenceHeight == 0 ? linesTop() + lineCount * line
                                     : captionTop() + line + gap + differenceHeight;
    }
    int rowTop(int row) const
    {
        return margin + headingHeight + row * (columnHeight() + 2 * margin);
    }
    int height() const // of the sheet
    {
        return rows == 0 ? margin + headingHeight : rowTop(rows - 1) + columnHeight() + margin;
    }
};

struct Sheet {
    Lettering text;
    Layout layout;
    Picture picture;
};

int widestPicture(const std::vector<SheetColumn>& columns)
{
    int width = 0;
    for (const SheetColumn& column : columns)
        width = std::max({width, column.picture.width, column.difference ? column.difference->width : 0});
    return width;
}

int widestText(const SheetColumn& column, const Lettering& text)
{
    int width = text.width(column.title);
    for (const std::string& line : column.lines)
        width = std::max(width, text.width(line));
    return width;
}

// As many beside each other as there is place for; of several rows each has the same number, but the last.
void arrange(Layout& layout, int count)
{
    const int pitch = layout.columnWidth + layout.margin;
    const int most = std::max(1, (widestSheet - layout.margin) / pitch);
    layout.rows = (count + most - 1) / most;
    layout.across = layout.rows == 0 ? 0 : (count + layout.rows - 1) / layout.rows;
    layout.width = layout.margin + layout.across * pitch;
}

// All but what the heading asks for.
Layout layoutOf(const std::vector<SheetColumn>& columns, const Lettering& text, int size)
{
    Layout layout{.margin = size, .gap = size / 3, .line = text.lineHeight()};
    layout.columnWidth = widestPicture(columns);
    for (const SheetColumn& column : columns) {
        const int needed = std::min(widestText(column, text), widestColumnText * size);
        layout.columnWidth = std::max(layout.columnWidth, needed);
        layout.pictureHeight = std::max(layout.pictureHeight, column.picture.height);
        if (column.difference) {
            layout.differenceWidth = std::max(layout.differenceWidth, column.difference->width);
            layout.differenceHeight = std::max(layout.differenceHeight, column.difference->height);
        }
        layout.lineCount = std::max(layout.lineCount, static_cast<int>(column.lines.size()));
    }
    arrange(layout, static_cast<int>(columns.size()));
    return layout;
}

// `top` is the upper edge of what is `height` high; gives the row of its lower edge, from the bottom.
int rowFromBottom(const Sheet& sheet, int top, int height)
{
    return sheet.picture.height - top - height;
}

void write(Sheet& sheet, const Lettering& lettering, const std::string& text, const PixelRectangle& fromTop,
           Colour8 colour)
{
    lettering.draw(sheet.picture, lettering.shortened(text, fromTop.width), fromTop.x,
                   rowFromBottom(sheet, fromTop.y, lettering.ascent()), colour);
}

// As large as the differences beside it; its label may be wider than it where pictures are narrow.
void drawEmptyCell(Sheet& sheet, const std::string& label, int x, int top)
{
    const Layout& layout = sheet.layout;
    const int width = layout.differenceWidth, height = layout.differenceHeight;
    blendRectangle(sheet.picture, {x, rowFromBottom(sheet, top, height), width, height}, emptyCell);
    const int left = x + std::max(0, (width - sheet.text.width(label)) / 2);
    const int labelTop = top + (height - layout.line) / 2;
    write(sheet, sheet.text, label, {left, labelTop, x + layout.columnWidth - left}, dim);
}

void drawColumn(Sheet& sheet, const SheetColumn& column, const DifferenceLabels& labels, int x, int top)
{
    const Layout& layout = sheet.layout;
    const int width = layout.columnWidth;
    write(sheet, sheet.text, column.title, {x, top, width}, bright);
    const int pictureTop = top + layout.line + layout.gap;
    paste(sheet.picture, column.picture, x, rowFromBottom(sheet, pictureTop, column.picture.height));
    int lineTop = top + layout.linesTop();
    for (const std::string& line : column.lines) {
        write(sheet, sheet.text, line, {x, lineTop, width}, dim);
        lineTop += layout.line;
    }
    if (layout.differenceHeight == 0)
        return;
    const int differenceTop = top + layout.captionTop() + layout.line + layout.gap;
    if (column.difference)
        paste(sheet.picture, *column.difference, x,
              rowFromBottom(sheet, differenceTop, column.difference->height));
    else
        drawEmptyCell(sheet, labels.withoutOne, x, differenceTop);
}

int scaleWidthOf(const DifferenceLabels& labels, int size)
{
    return labels.scale.empty() ? 0 : scaleWidth * size;
}

// What the row of differences shows, and its colours from none to the largest.
void drawCaption(Sheet& sheet, const DifferenceLabels& labels, int top)
{
    const Layout& layout = sheet.layout;
    const int barWidth = scaleWidthOf(labels, layout.margin), barHeight = layout.margin * 3 / 4;
    const int place = layout.width - 3 * layout.margin - barWidth;
    const std::string caption = sheet.text.shortened(labels.caption, place);
    write(sheet, sheet.text, caption, {layout.margin, top, place}, dim);
    const int left = layout.margin + (caption.empty() ? 0 : sheet.text.width(caption) + layout.margin);
    const int bottom = rowFromBottom(sheet, top, sheet.text.ascent());
    const auto count = static_cast<int>(labels.scale.size());
    for (int x = 0; x < barWidth; ++x)
        blendRectangle(sheet.picture, {left + x, bottom, 1, barHeight},
                       labels.scale[static_cast<std::size_t>(x * count / barWidth)]);
}

// Narrow columns do not cut what is said of all of them.
void widenForRowTexts(Layout& layout, const Lettering& text, const DifferenceLabels& labels, int headingWidth)
{
    const int size = layout.margin, most = widestRowText * size;
    layout.width = std::max(layout.width, 2 * size + std::min(headingWidth, most));
    if (layout.differenceHeight > 0)
        layout.width = std::max(layout.width, 3 * size + std::min(text.width(labels.caption), most) +
                                                  scaleWidthOf(labels, size));
}

} // namespace

Picture contactSheet(const std::string& heading, const std::vector<SheetColumn>& columns,
                     const DifferenceLabels& labels)
{
    const int size = legibleSize(widestPicture(columns));
    const Lettering large(size * 4 / 3);
    Sheet sheet{Lettering(size), {}, {}};
    Layout& layout = sheet.layout = layoutOf(columns, sheet.text, size);
    layout.headingHeight = heading.empty() ? 0 : large.lineHeight() + layout.margin;
    widenForRowTexts(layout, sheet.text, labels, large.width(heading));
    sheet.picture = blankCanvas(layout.width, layout.height(), background);
    write(sheet, large, heading, {layout.margin, layout.margin, layout.width - 2 * layout.margin}, bright);
    for (int row = 0; layout.differenceHeight > 0 && row < layout.rows; ++row)
        drawCaption(sheet, labels, layout.rowTop(row) + layout.captionTop());
    int place = 0;
    for (const SheetColumn& column : columns) {
        const int x = layout.margin + place % layout.across * (layout.columnWidth + layout.margin);
        drawColumn(sheet, column, labels, x, layout.rowTop(place / layout.across));
        ++place;
    }
    return std::move(sheet.picture);
}

} // namespace dioptre
