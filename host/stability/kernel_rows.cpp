#include "stability/kernel_rows.h"

#include "stability/random_floats.h"

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace
{

using glm::dvec3;
using glm::dvec4;

constexpr std::size_t rowTexels = 13;

// A row's texels, as shapes.frag names them.
struct Row {
    dvec4 origin{0.0}, direction{0.0}, directionLow{0.0}, anchor{0.0}, anchorLow{0.0}, axis{0.0},
        axisLow{0.0}, alongU{0.0}, alongV{0.0}, alongULow{0.0}, alongVLow{0.0}, surfaceNormal{0.0},
        surfaceNormalLow{0.0};
};
static_assert(sizeof(Row) == rowTexels * sizeof(dvec4));

void setSplit(dvec4& high, dvec4& low, const dvec3& v)
{
    const dvec3 rounded = asFloat(v);
    high = dvec4(rounded, high.w);
    low = dvec4(v - rounded, low.w);
}

// 2^-k for a length of about 2^k.
double scaleOf(double length)
{
    return std::isfinite(length) && length > 0.0 ? std::ldexp(1.0, -std::ilogb(length)) : 1.0;
}

dvec3 unitOrZero(const dvec3& v)
{
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    const dvec3 scaled = v / (largest > 0.0 ? largest : 1.0);
    const double size = std::sqrt(glm::dot(scaled, scaled));
    return size > 0.0 ? scaled / size : scaled;
}

class RowMaker
{
public:
    RowMaker(const RayProblem& problem, Variant variant, Frame frame)
        : problem_(problem), variant_(variant), moved_(frame == Frame::ofRay),
          scale_(moved_ ? scaleOf(extentOf(problem)) : 1.0)
    {
        setRay();
        if (problem.primitive == shapeSphere)
            setSphere();
        else if (problem.primitive <= shapeCappedCylinder)
            setCylinder();
        else
            setFlat();
    }

    const Row& row() const
    {
        return row_;
    }
    double lengthOfT() const
    {
        return lengthOfT_;
    }

private:
    dvec3 vector(std::size_t first) const
    {
        return scale_ * dvec3(problem_.p[first], problem_.p[first + 1], problem_.p[first + 2]);
    }
    dvec3 point(std::size_t first) const
    {
        const dvec3 world(problem_.p[first], problem_.p[first + 1], problem_.p[first + 2]);
        return scale_ * (moved_ ? world - problem_.origin : world);
    }

    // Compensated kernels take a direction of any length; the others get it unit where it is not already.
    void setRay()
    {
        dvec3 direction = problem_.direction;
        double step = 1.0; // of the row's t, in lengths of the given direction
        if (moved_) {
            step = scaleOf(glm::length(direction));
            direction *= step;
            step /= scale_;
        }
        const double size = glm::length(direction);
        if (variant_ != Variant::compensated && variant_ != Variant::textbook &&
            std::abs(size - 1.0) > 1.0e-6 && std::isfinite(size) && size > 0.0) {
            direction /= size;
            step /= size;
        }
        setSplit(row_.direction, row_.directionLow, direction);
        lengthOfT_ = step;
        row_.origin = dvec4(moved_ ? dvec3(0.0) : problem_.origin, problem_.tMin / step);
        row_.direction.w = problem_.spawn ? 1.0 : 0.0;
    }

    void setAnchor(const dvec3& anchor, double w)
    {
        setSplit(row_.anchor, row_.anchorLow, anchor);
        row_.anchor.w = w;
    }

    // The surface point nearest to the frame's origin, which lies at `outward` from the centre or the axis.
    void setSurfacePoint(const dvec3& outward, double radius)
    {
        const double distance = glm::length(outward);
        const dvec3 normal = distance > 0.0 ? outward / distance : dvec3(0.0, 1.0, 0.0);
        setAnchor((radius - distance) * normal, 1.0 / radius);
        setSplit(row_.surfaceNormal, row_.surfaceNormalLow, normal);
    }

    void setSphere()
    {
        const double radius = scale_ * problem_.p[3];
        if (variant_ == Variant::curvature)
            setSurfacePoint(-point(0), radius);
        else
            setAnchor(point(0), radius);
    }

    void setCylinder()
    {
        const dvec3 axis = vector(3);
        const dvec3 unit = unitOrZero(axis);
        const double radius = scale_ * problem_.p[6];
        const dvec3 base = point(0);
        const double height = glm::length(axis);
        setSplit(row_.axis, row_.axisLow, variant_ == Variant::compensated ? axis : unit);
        row_.axis.w = height;
        setAnchor(base, radius);
        if (variant_ == Variant::curvature) {
            const double above = -glm::dot(base, unit);
            setSurfacePoint(-base - above * unit, radius);
            row_.anchorLow.w = above;
        }
    }

    void setFlat()
    {
        const dvec3 anchor = point(0);
        setAnchor(anchor, problem_.primitive == shapeDisk ? scale_ * problem_.p[6] : 0.0);
        const dvec3 second = vector(3), third = vector(6);
        dvec3 normal = unitOrZero(second);
        if (problem_.primitive == shapeRectangle) {
            normal = unitOrZero(glm::cross(unitOrZero(second), unitOrZero(third)));
            const dvec3 across = glm::cross(second, third);
            const double square = glm::dot(across, across);
            row_.alongU = dvec4(glm::cross(third, across) / square, 0.0);
            row_.alongV = dvec4(glm::cross(across, second) / square, 0.0);
        } else if (problem_.primitive == shapeTriangle) {
            normal = unitOrZero(glm::cross(unitOrZero(second - vector(0)), unitOrZero(third - vector(0))));
            setSplit(row_.alongU, row_.alongULow, point(3));
            setSplit(row_.alongV, row_.alongVLow, point(6));
        }
        setSplit(row_.axis, row_.axisLow, normal);
    }

    const RayProblem& problem_;
    Variant variant_;
    bool moved_;
    double scale_;
    double lengthOfT_ = 1.0;
    Row row_;
};

} // namespace

KernelRows kernelRows(std::span<const RayProblem> problems, Variant variant, Frame frame)
{
    KernelRows rows{{rowTexels, {}}, {}};
    rows.table.numbers.reserve(problems.size() * rowTexels);
    for (const RayProblem& problem : problems) {
        const RowMaker maker(problem, variant, frame);
        const auto* const texels = reinterpret_cast<const dvec4*>(&maker.row());
        rows.table.numbers.insert(rows.table.numbers.end(), texels, texels + rowTexels);
        rows.lengthOfT.push_back(maker.lengthOfT());
    }
    return rows;
}

} // namespace dioptre
