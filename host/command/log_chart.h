// A chart with logarithmic axes, as SVG.
#pragma once

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace dioptre
{

struct ChartLine {
    std::string name;
    std::string colour;             // "#rrggbb"
    std::vector<glm::dvec2> points; // both coordinates above 0
};

struct LogChart {
    std::string title;
    std::string xLabel;
    std::string yLabel;
    int xLow = 0, xHigh = 1; // decades
    int yLow = 0, yHigh = 1;
    std::vector<ChartLine> lines;
};

// Points outside are drawn at the border.
std::string svgOf(const LogChart& chart);

} // namespace dioptre
