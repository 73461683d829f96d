#include "base/file.h"
#include "base/text.h"
#include "command/command.h"
#include "command/input.h"
#include "command/json_text.h"
#include "gl/context.h"
#include "raster/method.h"
#include "render/data_view.h"
#include "render/layers.h"
#include "scene/choices.h"
#include "scene/load.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace dioptre
{
namespace
{

// Objects with the same keys; the values are texts and numbers.
using Rows = std::vector<nlohmann::ordered_json>;

struct Listing {
    std::string name;
    Rows rows;
};

// A scene that does not load is listed with the reason: it must not hide the others.
Rows scenes()
{
    Rows rows;
    for (const std::string& name : galleryNames()) {
        try {
            const Scene scene = loadScene(findInput(name).path, {}, 0.0, searchPlaces());
            rows.push_back({{"name", name}, {"title", scene.title}, {"objects", scene.objects.size()}});
        } catch (const Error& error) {
            rows.push_back({{"name", name}, {"title", ""}, {"objects", 0}, {"fault", error.what()}});
        }
    }
    return rows;
}

// Plain shaders say what they are in the first sentence of their heading comment.
Rows shaders()
{
    Rows rows;
    for (const std::string& name : galleryShaders()) {
        const std::string text = readFile(findInput(name).path);
        const auto start = std::min(text.find_first_not_of("/ "), text.size());
        rows.push_back(
            {{"name", name}, {"title", text.substr(start, text.find_first_of(".\n", start) - start)}});
    }
    return rows;
}

// From any table whose entries have a name and a meaning.
template <class Table>
Rows namesIn(const Table& table)
{
    Rows rows;
    for (const auto& entry : table)
        rows.push_back({{"name", entry.name}, {"meaning", entry.meaning}});
    return rows;
}

// The same where the meaning has another name.
template <class Row>
Rows rowsOf(const std::vector<Row>& table, const char* Row::*meaning)
{
    Rows rows;
    for (const auto& row : table)
        rows.push_back({{"name", row.name}, {"meaning", row.*meaning}});
    return rows;
}

std::vector<Listing> listings()
{
    return {{"scenes", scenes()},
            {"shaders", shaders()},
            {"methods", namesIn(shadings)},
            {"orders", namesIn(treeOrders)},
            {"forms", namesIn(sceneForms)},
            {"views", rowsOf(dataViews(), &DataViewRow::shows)},
            {"layers", rowsOf(layerRows(), &LayerRow::holds)},
            {"curves", namesIn(toneCurves)},
            {"shadow_filters", namesIn(shadowFilters)},
            {"backends", namesIn(backendChoices())}};
}

// A count reads "10 objects"; a text stands for itself.
std::string cell(const std::string& key, const nlohmann::ordered_json& value)
{
    return value.is_string() ? value.get<std::string>() : fmt::format("{} {}", value.dump(), key);
}

// Columns as wide as their longest cell.
std::string textOf(const Listing& listing)
{
    std::vector<std::vector<std::string>> lines;
    std::vector<std::size_t> widths;
    for (const auto& row : listing.rows) {
        std::vector<std::string> line;
        for (const auto& [key, value] : row.items()) {
            line.push_back(cell(key, value));
            widths.resize(std::max(widths.size(), line.size()));
            widths[line.size() - 1] = std::max(widths[line.size() - 1], line.back().size());
        }
        lines.push_back(line);
    }
    std::string text = listing.name + "\n";
    for (const auto& line : lines) {
        std::string row = " ";
        for (std::size_t column = 0; column < line.size(); ++column)
            row += fmt::format(" {:{}} ", line[column], widths[column]);
        text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

} // namespace

ExitCode list(const ListOptions& options)
{
    nlohmann::ordered_json json;
    std::vector<std::string> texts;
    for (const Listing& listing : listings()) {
        json[listing.name] = listing.rows;
        texts.push_back(textOf(listing));
    }
    fmt::print("{}", options.json ? jsonText(json) : join(texts, "\n"));
    return ExitCode::done;
}

} // namespace dioptre
