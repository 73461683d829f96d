// LDR-FLIP a second time, as the paper writes it: each filter a square of weights, each pixel a sum over it.
// Slow and plain, to hold the fast one to; it shares no code with it, not even the matrix of colours.
#pragma once

#include "metric/pair.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace dioptre::test
{

using Numbers = std::array<double, 3>;

// Weights at (x, y) from -radius to radius, x running fastest.
struct Square {
    int radius = 0;
    std::vector<double> weights;
};

inline Square square(int radius, const std::function<double(double x, double y)>& weightAt)
{
    Square result{radius, {}};
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x)
            result.weights.push_back(weightAt(x, y));
    return result;
}

// Positive weights to sum to 1, negative ones to -1.
inline Square balanced(Square result)
{
    double positive = 0.0, negative = 0.0;
    for (const double weight : result.weights)
        (weight > 0 ? positive : negative) += std::abs(weight);
    for (double& weight : result.weights)
        weight /= weight > 0 ? positive : negative;
    return result;
}

class DirectFlip
{
public:
    DirectFlip(int width, int height, double pixelsPerDegree) : width_(width), height_(height)
    {
        constexpr double pi = std::numbers::pi;
        const int radius = static_cast<int>(std::ceil(3 * std::sqrt(0.04 / (2 * pi * pi)) * pixelsPerDegree));
        const auto contrast = [&](double a1, double b1, double a2, double b2) {
            return balanced(square(radius, [=](double x, double y) {
                const double z = (x * x + y * y) / (pixelsPerDegree * pixelsPerDegree);
                return a1 * std::sqrt(pi / b1) * std::exp(-pi * pi * z / b1) +
                       a2 * std::sqrt(pi / b2) * std::exp(-pi * pi * z / b2);
            }));
        };
        contrast_ = {contrast(1, 0.0047, 0, 1e-5), contrast(1, 0.0053, 0, 1e-5),
                     contrast(34.1, 0.04, 13.5, 0.025)};
        const double s = 0.5 * 0.082 * pixelsPerDegree;
        const auto feature = [s](const std::function<double(double x, double y)>& factor) {
            return balanced(square(static_cast<int>(std::ceil(3 * s)), [&](double x, double y) {
                return factor(x, y) * std::exp(-(x * x + y * y) / (2 * s * s));
            }));
        };
        edges_ = {feature([](double x, double) { return -x; }), feature([](double, double y) { return -y; })};
        points_ = {feature([s](double x, double) { return x * x / (s * s) - 1; }),
                   feature([s](double, double y) { return y * y / (s * s) - 1; })};
    }

    double error(const PicturePair& pair, int x, int y) const
    {
        const auto reference = opponents(pair.reference), picture = opponents(pair.picture);
        const double edge = std::abs(strength(reference, edges_, x, y) - strength(picture, edges_, x, y)),
                     point = std::abs(strength(reference, points_, x, y) - strength(picture, points_, x, y));
        const double feature = std::sqrt(std::max(edge, point) / std::numbers::sqrt2);
        const Numbers a = lab(seen(reference, x, y)), b = lab(seen(picture, x, y));
        const double largest = std::pow(hyab(lab({0, 1, 0}), lab({0, 0, 1})), 0.7);
        const double colour = std::pow(hyab(a, b), 0.7), knee = 0.4 * largest;
        return std::pow(colour < knee ? 0.95 / knee * colour
                                      : 0.95 + (colour - knee) / (largest - knee) * 0.05,
                        1.0 - feature);
    }

private:
    static constexpr Numbers white{0.950428545, 1.0, 1.088900371};

    static Numbers xyz(const Numbers& c)
    {
        return {(10135552 * c[0] + 8788810 * c[1] + 4435075 * c[2]) / 24577794 / white[0],
                (2613072 * c[0] + 8788810 * c[1] + 887015 * c[2]) / 12288897,
                (1425312 * c[0] + 8788810 * c[1] + 70074185 * c[2]) / 73733382 / white[2]};
    }

    static std::vector<Numbers> opponents(const std::vector<glm::vec3>& colours)
    {
        std::vector<Numbers> result;
        for (const auto& c : colours) {
            const auto [x, y, z] =
                xyz({static_cast<double>(c.r), static_cast<double>(c.g), static_cast<double>(c.b)});
            result.push_back({116 * y - 16, 500 * (x - y), 200 * (y - z)});
        }
        return result;
    }

    double sum(const std::vector<Numbers>& colours, const Square& filter, std::size_t channel, int x,
               int y) const
    {
        double total = 0.0;
        auto weight = filter.weights.begin();
        for (int j = -filter.radius; j <= filter.radius; ++j)
            for (int i = -filter.radius; i <= filter.radius; ++i) {
                const int column = std::clamp(x + i, 0, width_ - 1), row = std::clamp(y + j, 0, height_ - 1);
                total += *weight++ * colours[static_cast<std::size_t>(row * width_ + column)][channel];
            }
        return total;
    }

    // The channel y is (Yy + 16) / 116; balanced filters do not see the 16.
    double strength(const std::vector<Numbers>& colours, const std::array<Square, 2>& filters, int x,
                    int y) const
    {
        return std::hypot(sum(colours, filters[0], 0, x, y), sum(colours, filters[1], 0, x, y)) / 116;
    }

    // Linear RGB in 0..1; the inverse matrix as FLIP's authors print it.
    Numbers seen(const std::vector<Numbers>& colours, int x, int y) const
    {
        const double v = (sum(colours, contrast_[0], 0, x, y) + 16) / 116;
        const double u = (v + sum(colours, contrast_[1], 1, x, y) / 500) * white[0],
                     w = (v - sum(colours, contrast_[2], 2, x, y) / 200) * white[2];
        return {std::clamp(3.241003275 * u - 1.537398934 * v - 0.498615861 * w, 0.0, 1.0),
                std::clamp(-0.969224334 * u + 1.875930071 * v + 0.041554224 * w, 0.0, 1.0),
                std::clamp(0.055639423 * u - 0.204011202 * v + 1.057148933 * w, 0.0, 1.0)};
    }

    static Numbers lab(const Numbers& rgb)
    {
        Numbers f = xyz(rgb);
        for (double& t : f)
            t = t > 216.0 / 24389.0 ? std::cbrt(t) : 841.0 / 108.0 * t + 4.0 / 29.0;
        const double l = 116 * f[1] - 16;
        return {l, 0.01 * l * 500 * (f[0] - f[1]), 0.01 * l * 200 * (f[1] - f[2])};
    }

    static double hyab(const Numbers& a, const Numbers& b)
    {
        return std::abs(a[0] - b[0]) + std::hypot(a[1] - b[1], a[2] - b[2]);
    }

    int width_, height_;
    std::array<Square, 3> contrast_;
    std::array<Square, 2> edges_, points_;
};

} // namespace dioptre::test
