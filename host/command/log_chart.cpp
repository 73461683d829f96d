#include "command/log_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

constexpr double left = 70.0, right = 610.0, top = 40.0, bottom = 350.0; // of the plotted part, pixels
constexpr int width = 760, height = 410;

std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text)
        result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : std::string(1, c);
    return result;
}

double along(double value, int low, int high, double from, double to)
{
    const double share = (std::log10(value) - low) / (high - low);
    return from + std::clamp(share, 0.0, 1.0) * (to - from);
}

std::string gridText(const LogChart& chart)
{
    std::string text;
    for (int decade = chart.xLow; decade <= chart.xHigh; ++decade) {
        const double x = along(std::pow(10.0, decade), chart.xLow, chart.xHigh, left, right);
        text += fmt::format("<path d=\"M{0:.1f} {1}V{2}\" stroke=\"#ddd\"/>\n"
                            "<text x=\"{0:.1f}\" y=\"{3}\" text-anchor=\"middle\">1e{4}</text>\n",
                            x, top, bottom, bottom + 18.0, decade);
    }
    for (int decade = chart.yLow; decade <= chart.yHigh; ++decade) {
        const double y = along(std::pow(10.0, decade), chart.yLow, chart.yHigh, bottom, top);
        text += fmt::format("<path d=\"M{0} {1:.1f}H{2}\" stroke=\"#ddd\"/>\n"
                            "<text x=\"{3}\" y=\"{4:.1f}\" text-anchor=\"end\">1e{5}</text>\n",
                            left, y, right, left - 8.0, y + 4.0, decade);
    }
    return text;
}

std::string lineText(const LogChart& chart, const ChartLine& line, std::size_t index)
{
    std::string path;
    for (const glm::dvec2& point : line.points)
        path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L",
                            along(point.x, chart.xLow, chart.xHigh, left, right),
                            along(point.y, chart.yLow, chart.yHigh, bottom, top));
    const double y = top + 12.0 + 22.0 * static_cast<double>(index);
    return fmt::format("<path d=\"{0}\" fill=\"none\" stroke=\"{1}\" stroke-width=\"2\"/>\n"
                       "<path d=\"M{2} {3}h24\" stroke=\"{1}\" stroke-width=\"2\"/>\n"
                       "<text x=\"{4}\" y=\"{5}\">{6}</text>\n",
                       path, line.colour, right + 14.0, y, right + 44.0, y + 4.0, escaped(line.name));
}

} // namespace

std::string svgOf(const LogChart& chart)
{
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0}\" height=\"{1}\" viewBox=\"0 0 {0} {1}\" "
        "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"{0}\" height=\"{1}\" fill=\"white\"/>\n"
        "<text x=\"{2}\" y=\"24\" font-size=\"15\">{3}</text>\n",
        width, height, left, escaped(chart.title));
    text += gridText(chart);
    for (std::size_t i = 0; i < chart.lines.size(); ++i)
        text += lineText(chart, chart.lines[i], i);
    return text + fmt::format("<text x=\"{0}\" y=\"{1}\" text-anchor=\"middle\">{2}</text>\n"
                              "<text transform=\"translate(16 {3}) rotate(-90)\" text-anchor=\"middle\">{4}"
                              "</text>\n</svg>\n",
                              (left + right) / 2.0, bottom + 42.0, escaped(chart.xLabel),
                              (top + bottom) / 2.0, escaped(chart.yLabel));
}

} // namespace dioptre
