// The rasterised methods beside the tracer: what they approach as facets get finer, what they cannot show,
// and that they draw every scene.
#include "support/compare.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

// One shape under every kind of light, without shadows, mirrors and glass.
std::string lit(const std::string& shape)
{
    return "[camera]\neye = [0, 1.2, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n[sky]\ncolour = [0.2, 0.3, "
           "0.4]\n"
           "[material.m]\ncolour = [0.8, 0.4, 0.2]\nmodel = \"phong\"\nspecular = [0.5, 0.5, 0.5]\n"
           "shininess = 12\nshadow = \"none\"\n"
           "[[light]]\nkind = \"ambient\"\nambient = [0.1, 0.1, 0.1]\n"
           "[[light]]\nkind = \"point\"\nposition = [2, 3, 3]\ndiffuse = [0.5, 0.5, 0.5]\n"
           "[[light]]\nkind = \"directional\"\ndirection = [1, -1, -1]\ndiffuse = [0.3, 0.3, 0.3]\n" +
           shape + "material = \"m\"\n";
}

const std::string sphere = "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\n";
const std::string can =
    "[[cylinder]]\nbase = [-0.2, -0.8, 0]\naxis = [0.4, 1.5, 0.2]\nradius = 0.7\ncapped = true\n";
const std::string disk = "[[disk]]\ncentre = [0, 0, 0]\nnormal = [0.3, 0.6, 1]\nradius = 1.1\n";

Rendered by(const std::string& method, const std::string& toml, int samples = 4,
            std::vector<std::string> overrides = {})
{
    return renderSceneText(toml,
                           {192, 144, samples, std::move(overrides), "auto", 0.0, DataView::none, method});
}

// RMSE over the pixels that both pictures cover whole with the shape: those at which neither shows any sky.
double rmseWithin(const Picture& a, const Picture& b, const Picture& coverage)
{
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t i = 0; i < a.floats.size(); i += 4)
        if (coverage.floats[i] == 0.0F)
            for (std::size_t c = 0; c < 3; ++c, count += 1.0)
                sum +=
                    std::pow(static_cast<double>(a.floats[i + c]) - static_cast<double>(b.floats[i + c]), 2);
    return std::sqrt(sum / count);
}

// Where the shape leaves a pixel or one beside it to the sky, 1; else 0. From a black shape before a white
// sky.
Picture coverageOf(const std::string& method, const std::string& shape)
{
    const Picture shown =
        by(method,
           "[camera]\neye = [0, 1.2, 4]\ntarget = [0, 0, 0]\nfov_y_deg = 40\n[sky]\ncolour = [1, 1, 1]\n" +
               shape)
            .picture;
    Picture near = shown;
    for (int y = 0; y < shown.height; ++y)
        for (int x = 0; x < shown.width; ++x)
            for (int dy = -2; dy <= 2; ++dy)
                for (int dx = -2; dx <= 2; ++dx) {
                    const int column = std::clamp(x + dx, 0, shown.width - 1);
                    const int row = std::clamp(y + dy, 0, shown.height - 1);
                    float& value = near.floats[static_cast<std::size_t>(4 * (y * shown.width + x))];
                    value = std::max(
                        value, shown.floats[static_cast<std::size_t>(4 * (row * shown.width + column))]);
                }
    return near;
}

} // namespace

// Phong's normals are off by the square of a facet's angle, and so is its light; whole pixels along the
// outline are off, in a band as wide as that square, too, whose RMSE falls with its root.
TEST(Rasterised, PhongConvergesToTheTracersPicture)
{
    for (const auto& [name, shape] :
         {std::pair("sphere", sphere), {"capped cylinder", can}, {"disk", disk}}) {
        const Picture traced = by("trace", lit(shape)).picture;
        double before = 0.0;
        double beforeWithin = 0.0;
        double wholeOrder = 0.0;
        double withinOrder = 0.0;
        int doublings = 0;
        for (const int n : {8, 16, 32, 64}) {
            const auto method = fmt::format("phong:{}", n);
            const Picture drawn = by(method, lit(shape)).picture;
            const double rmse = compare(drawn, traced, 0.01).rmse;
            const double within = rmseWithin(drawn, traced, coverageOf(method, shape));
            std::cout << name << " " << method << ": RMSE " << rmse << ", within the outline " << within
                      << "\n";
            if (n > 8) {
                EXPECT_LT(rmse, before) << name << ": " << method;
                EXPECT_LE(within, std::max(beforeWithin, 2e-6)) << name << ": " << method;
                wholeOrder += std::log2(before / rmse);
                withinOrder += std::log2(beforeWithin / std::max(within, 1e-9));
                ++doublings;
            }
            before = rmse;
            beforeWithin = within;
        }
        std::cout << name << ": order " << wholeOrder / doublings << ", within the outline "
                  << withinOrder / doublings << "\n";
    }
}
