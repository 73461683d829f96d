// The ways to draw a scene: traced, or rasterised from facets.
#pragma once

#include <array>
#include <string>
#include <string_view>

namespace dioptre
{

enum class Shading { trace, flat, gouraud, phong };

// A way to draw a scene.
struct Method {
    Shading shading = Shading::trace;
    int facets = 0; // along each side of a shape's net, leastFacets to mostFacets; 0 where it is traced
    bool operator==(const Method&) const = default;
};

inline constexpr int leastFacets = 8;
inline constexpr int mostFacets = 512;
inline constexpr int usualFacets = 64;

struct ShadingRow {
    std::string_view name; // as --method has it before the colon
    Shading shading;
    std::string_view meaning; // a phrase for people
};

inline constexpr std::array shadings{
    ShadingRow{"trace", Shading::trace, "rays are traced to the shapes themselves"},
    ShadingRow{"flat", Shading::flat, "N x N facets a shape, each lit once, in its middle"},
    ShadingRow{"gouraud", Shading::gouraud, "lit at the facets' corners, and light mixed between them"},
    ShadingRow{"phong", Shading::phong, "lit in every pixel, by normals mixed between the facets' corners"},
};

// "trace", "phong:64", or "phong" for usualFacets. Throws usage.
Method methodNamed(const std::string& text);

// "trace", "phong:64"
std::string nameOf(const Method& method);

inline bool isRasterised(const Method& method)
{
    return method.shading != Shading::trace;
}

// Whether planes are drawn to infinity: where pixels are lit. Facets and vertices need places to be lit at.
inline bool hasEndlessPlanes(const Method& method)
{
    return method.shading == Shading::phong;
}

} // namespace dioptre
