#include "oracle/silhouette.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace dioptre
{
namespace
{

// Vectors seen along the line: their parts across it, in double.
class LineView
{
public:
    explicit LineView(const QuadRay& line)
        : line_(line), perSquare_(1 / dot(line.direction, line.direction)),
          forwards_(glm::normalize(doubleFrom((sqrtq(perSquare_)) * line.direction)))
    {
    }

    // Where a point appears, relative to the line.
    glm::dvec3 place(const QuadVec& point) const
    {
        return across(point - line_.origin);
    }

    glm::dvec3 across(const QuadVec& v) const
    {
        return doubleFrom(v - (dot(v, line_.direction) * perSquare_) * line_.direction);
    }

    const glm::dvec3& forwards() const // unit
    {
        return forwards_;
    }

private:
    const QuadRay& line_;
    Quad perSquare_;
    glm::dvec3 forwards_;
};

// A circle about an axis, or a cylinder along it, appears symmetric to these two directions.
struct TiltedFrame {
    glm::dvec3 x, y; // unit; x along the axis as it appears
    double sine;     // of the angle between axis and line
    double cosine;   // its magnitude
};

TiltedFrame tiltedFrame(const LineView& view, const QuadVec& axis)
{
    const QuadVec unitAxis = unit(axis);
    const glm::dvec3 along = view.across(unitAxis);
    const double sine = glm::length(along);
    const glm::dvec3 any = std::abs(view.forwards().x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 x = sine > 0.0 ? along / sine : glm::normalize(glm::cross(view.forwards(), any));
    return {x, glm::cross(view.forwards(), x), sine,
            std::abs(glm::dot(doubleFrom(unitAxis), view.forwards()))};
}

double distanceToRim(const TiltedFrame& frame, double radius, const glm::dvec3& centre)
{
    return distanceToEllipse(radius * frame.cosine, radius, glm::dot(centre, frame.x),
                             glm::dot(centre, frame.y));
}

double distanceToCylinderBounds(const QuadShape& shape, const LineView& view)
{
    const TiltedFrame frame = tiltedFrame(view, shape.first);
    const auto radius = static_cast<double>(shape.radius);
    const glm::dvec3 base = view.place({0, 0, 0});
    const glm::dvec3 top = view.place(shape.first);
    // The wall's silhouette: two segments, radius away from the axis as it appears, which begins at the base.
    const double x = -glm::dot(base, frame.x);
    const double y = std::abs(glm::dot(base, frame.y));
    const double beyond = x - std::clamp(x, 0.0, glm::dot(top - base, frame.x));
    return std::min({std::hypot(beyond, y - radius), distanceToRim(frame, radius, base),
                     distanceToRim(frame, radius, top)});
}

double distanceToSegment(const glm::dvec3& start, const glm::dvec3& end)
{
    const glm::dvec3 along = end - start;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(-glm::dot(start, along) / square, 0.0, 1.0) : 0.0;
    return glm::length(start + share * along);
}

double distanceToEdges(std::span<const glm::dvec3> corners)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i)
        nearest = std::min(nearest, distanceToSegment(corners[i], corners[(i + 1) % corners.size()]));
    return nearest;
}

// The root w of (ratio x / (w + ratio - 1))^2 + (y / w)^2 = 1 above 0, for x >= 0 and y > 0: Eberly's s + 1,
// which keeps the digits that s loses near -1.
double nearestParameter(double ratio, double x, double y)
{
    double low = y;
    double high = std::max(1.0, std::hypot(ratio * x, y));
    for (;;) {
        const double middle = 0.5 * (low + high);
        if (!(middle > low && middle < high))
            return middle;
        const double u = ratio * x / (middle + (ratio - 1.0));
        const double v = y / middle;
        (u * u + v * v > 1.0 ? low : high) = middle;
    }
}

} // namespace

// Eberly, "Distance from a point to an ellipse, an ellipsoid, or a hyperellipsoid", 2013, section 2.
double distanceToEllipse(double halfX, double halfY, double x, double y)
{
    x = std::abs(x);
    y = std::abs(y);
    if (halfX < halfY) {
        std::swap(halfX, halfY);
        std::swap(x, y);
    }
    if (halfY < 1e-12 * halfX) // seen edge-on it is a segment, to within 2e-5 of the margin's unit
        return std::hypot(std::max(x - halfX, 0.0), y);
    if (y > 0.0) {
        const double ratio = (halfX / halfY) * (halfX / halfY);
        const double w = nearestParameter(ratio, x / halfX, y / halfY);
        return std::hypot(ratio * x / (w + (ratio - 1.0)) - x, y / w - y);
    }
    const double focal = halfX * halfX - halfY * halfY;
    if (halfX * x < focal) {
        const double share = halfX * x / focal;
        return std::hypot(halfX * share - x, halfY * std::sqrt(1.0 - share * share));
    }
    return std::abs(x - halfX);
}

double distanceToBounds(const QuadShape& shape, const QuadRay& line)
{
    const LineView view(line);
    const glm::dvec3 reference = view.place({0, 0, 0});
    switch (shape.primitive) {
    case shapeSphere:
        return std::abs(glm::length(reference) - static_cast<double>(shape.radius));
    case shapeOpenCylinder:
    case shapeCappedCylinder:
        return distanceToCylinderBounds(shape, view);
    case shapePlane:
        return dot(shape.first, line.direction) == 0 ? 0.0 : std::numeric_limits<double>::infinity();
    case shapeDisk:
        return distanceToRim(tiltedFrame(view, shape.first), static_cast<double>(shape.radius), reference);
    default:
        break;
    }
    const glm::dvec3 u = view.place(shape.first);
    const glm::dvec3 v = view.place(shape.second);
    if (shape.primitive == shapeTriangle)
        return distanceToEdges(std::array{reference, u, v});
    return distanceToEdges(std::array{reference, u, u + v - reference, v});
}

} // namespace dioptre
