#include "oracle/line_roots.h"

#include <cmath>

namespace dioptre
{
namespace
{

// The implicit function along the line, over R^2: below 0 inside. x runs from the point nearest to the
// centre, in units that bring `quadratic` near 1, so that neither precision can overflow.
template <typename Real>
struct Parabola {
    Real quadratic, linear, constant;

    Real at(Real x) const
    {
        return constant + x * (linear + x * quadratic);
    }
    Real slopeAt(Real x) const
    {
        return linear + 2 * quadratic * x;
    }
};

// The root between a point inside and a point outside, by Newton's steps; a step out of the bracket halves it
// instead. Ends when a step moves the root by less than `resolution` of it.
template <typename Real>
Real rootBetween(const Parabola<Real>& f, Real inside, Real outside, Real start, Real resolution)
{
    Real x = start;
    constexpr int most = 400; // halvings alone reach the resolution of either precision
    for (int i = 0; i < most; ++i) {
        const Real value = f.at(x);
        if (value == 0)
            return x;
        (value < 0 ? inside : outside) = x;
        Real next = x - value / f.slopeAt(x);
        const bool within = (next > inside && next < outside) || (next < inside && next > outside);
        if (!within)
            next = (inside + outside) / 2;
        const Real step = next < x ? x - next : next - x;
        x = next;
        if (step <= resolution * (x < 0 ? -x : x))
            break;
    }
    return x;
}

// The root on one side of the nearest point, where f falls below 0; f is above 0 at `outside`. Double
// precision narrows the bracket, quad decides whether it still is one and finds the root in it.
Quad bracketedRoot(const Parabola<Quad>& f, double outside)
{
    constexpr double coarse = 0x1p-48;
    const Quad fine =
        static_cast<Quad>(0x1p-60) * static_cast<Quad>(0x1p-48); // a Newton step later it is below 2^-113
    const Parabola<double> rough{static_cast<double>(f.quadratic), static_cast<double>(f.linear),
                                 static_cast<double>(f.constant)};
    const double guess = rootBetween(rough, 0.0, outside, outside, coarse);
    const Quad start = guess;
    const Quad inner = start * static_cast<Quad>(1.0 - 0x1p-40);
    const Quad outer = start * static_cast<Quad>(1.0 + 0x1p-40);
    if (f.at(inner) < 0 && f.at(outer) > 0)
        return rootBetween<Quad>(f, inner, outer, start, fine);
    return rootBetween<Quad>(f, 0, outside, outside, fine);
}

} // namespace

LineRoots roundRoots(const QuadVec& offset, const QuadVec& direction, Quad radius)
{
    const Quad dd = dot(direction, direction);
    if (!(dd > 0))
        return {};
    const Quad nearest = -dot(offset, direction) / dd;
    const QuadVec h = offset + nearest * direction;
    const Quad perSquare = 1 / (radius * radius);
    const Quad constant = dot(h, h) * perSquare - 1;
    if (constant > 0)
        return {};
    if (constant == 0)
        return {2, {nearest, nearest}};
    // At twice this distance from the nearest point the line is outside: |h|^2 >= 0 and R^2 < (2 R)^2.
    const Quad reach = radius / sqrtq(dd);
    const Parabola<Quad> f{reach * reach * dd * perSquare, 2 * reach * dot(h, direction) * perSquare,
                           constant};
    return {2, {nearest + reach * bracketedRoot(f, -2.0), nearest + reach * bracketedRoot(f, 2.0)}};
}

} // namespace dioptre
