// A row of the panel as its user sees it: a label, a value, and a mark where the value was changed.
#pragma once

#include "live/panel_row.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// What was done to a row.
struct RowDeed {
    std::optional<std::vector<double>> numbers; // new ones, which fit
    bool putBack = false;                       // to what the file has
};

RowDeed drawRow(const PanelRow& row, bool isChanged);

// Rows under headings for their groups, and one more for each section; `draw` is called for the rows that are
// to be seen. A group of several sections is closed at first: their names are what is looked for.
void drawRows(const std::vector<PanelRow>& rows, const std::function<bool(const PanelRow&)>& isChanged,
              const std::function<void(const PanelRow&)>& draw);

// Where the right column begins.
float labelColumn_px();

// A label in the left column; what comes next stands in the right one.
void drawLabel(const std::string& label, bool isMarked = false);

// Text in both columns, cut to their widths; a hint has all of it.
void drawFact(const std::string& label, const std::string& text);

// The same with the right column where it is told to begin.
void drawFactAt(float column_px, const std::string& label, const std::string& text);

// Shown under the pointer where it rests on the last widget.
void drawHint(const std::string& text);

// Text cut to so many pixels.
std::string elided(const std::string& text, float width_px);

} // namespace dioptre
