// IEEE binary128 numbers, which carry about 34 digits, computed in software; and vectors of them.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

__extension__ typedef __float128 Quad;

struct QuadVec {
    Quad x, y, z;
};

} // namespace dioptre

// From libquadmath, whose own header only g++ reads; clang builds the fuzz targets.
extern "C" {
dioptre::Quad sqrtq(dioptre::Quad) noexcept;
dioptre::Quad sinq(dioptre::Quad) noexcept;
dioptre::Quad cosq(dioptre::Quad) noexcept;
dioptre::Quad tanq(dioptre::Quad) noexcept;
dioptre::Quad asinq(dioptre::Quad) noexcept;
dioptre::Quad acosq(dioptre::Quad) noexcept;
dioptre::Quad atan2q(dioptre::Quad, dioptre::Quad) noexcept;
dioptre::Quad logq(dioptre::Quad) noexcept;
dioptre::Quad powq(dioptre::Quad, dioptre::Quad) noexcept;
}

namespace dioptre
{

inline Quad magnitude(Quad x)
{
    return x < 0 ? -x : x;
}

inline QuadVec quadFrom(const glm::dvec3& v)
{
    return {v.x, v.y, v.z};
}

inline glm::dvec3 doubleFrom(const QuadVec& v)
{
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

inline QuadVec operator+(const QuadVec& a, const QuadVec& b)
{
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

inline QuadVec operator-(const QuadVec& a, const QuadVec& b)
{
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

inline QuadVec operator*(Quad scale, const QuadVec& v)
{
    return {scale * v.x, scale * v.y, scale * v.z};
}

inline Quad dot(const QuadVec& a, const QuadVec& b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

inline QuadVec cross(const QuadVec& a, const QuadVec& b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

// Not for the zero vector.
inline QuadVec unit(const QuadVec& v)
{
    return (1 / sqrtq(dot(v, v))) * v;
}

// Of vectors of any length, 0 to pi: by the arctangent, which keeps its digits near 0 and pi.
inline Quad angleBetween_rad(const QuadVec& a, const QuadVec& b)
{
    const QuadVec sine = cross(a, b);
    return atan2q(sqrtq(dot(sine, sine)), dot(a, b));
}

} // namespace dioptre
