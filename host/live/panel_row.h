// A value that a user may change, as a row of the panel: where it goes, what it is now and what it may
// become.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace dioptre
{

enum class RowKind { number, integer, toggle, choice, colour, vector };

struct RowWord {
    std::string value; // TOML
    std::string label; // for people
};

struct PanelRow {
    std::string group{};   // "Materials"
    std::string section{}; // "glass"; "" where the group is all there is
    std::string path{};    // as --set takes it: "material.glass.ior"; of a plain shader the uniform's name
    std::string label{};
    RowKind kind = RowKind::number;
    std::vector<double> numbers{}; // as they are; 0 or 1 of a toggle, of a choice the place in `words`
    double low = 0.0;              // of each number
    double high = 1.0;
    bool logarithmic = false;
    std::vector<RowWord> words{};
    std::string unset{};    // what stands in place of numbers that nobody gave: "no limit"
    bool nonZero = false;   // one number at least must not be 0
    bool hasEffect = true;  // false: on the picture as it is
    bool isEncoded = false; // a colour that is shown as it is; else linear
    std::string fixedBy{};  // what keeps it from being changed: "animated"
    std::string meaning{};  // more than the label says
};

// The numbers as the row allows them: within its range, whole where they must be. What must not be 0 stays as
// it is.
std::vector<double> fitted(const PanelRow& row, std::vector<double> numbers);

// Fitting numbers as --set and a scene file take them.
std::string tomlOf(const PanelRow& row, const std::vector<double>& numbers);

// Whether one path leads to the other's value or to a part of it: "light.0.position" and
// "light.0.position.1".
bool overlap(std::string_view a, std::string_view b);

} // namespace dioptre
