#include "oracle/paths.h"

#include "oracle/quad.h"

namespace dioptre
{

double ballDeviation_rad(double offset, double index)
{
    const Quad i = asinq(offset);
    const Quad r = asinq(static_cast<Quad>(offset) / static_cast<Quad>(index));
    return static_cast<double>(2 * (i - r));
}

double slabOffset_m(double thickness_m, double incidence_rad, double index)
{
    const Quad i = incidence_rad;
    const Quad r = asinq(sinq(i) / static_cast<Quad>(index));
    return static_cast<double>(static_cast<Quad>(thickness_m) * sinq(i - r) / cosq(r));
}

MirrorStop facingMirrors(double gap_m, const glm::dvec3& origin, const glm::dvec3& direction, int bounce)
{
    const QuadVec o = quadFrom(origin);
    const QuadVec d = unit(quadFrom(direction));
    const Quad gap = gap_m;
    const bool rising = direction.z > 0.0;
    // The wall met is the k-th beyond the room that the ray starts in.
    const Quad firstWall = rising ? gap : 0;
    const Quad unfolded = firstWall + (rising ? gap : -gap) * static_cast<Quad>(bounce - 1);
    const Quad length = (unfolded - o.z) / d.z;
    const bool odd = bounce % 2 == 1;
    const QuadVec point{o.x + length * d.x, o.y + length * d.y, rising == odd ? gap : 0};
    const QuadVec onwards{d.x, d.y, odd ? -d.z : d.z};
    return {doubleFrom(point), doubleFrom(onwards), static_cast<double>(length)};
}

glm::dvec2 whisperingGallery(double radius_m, double glancing_rad, int bounce)
{
    const Quad angle_rad = 2 * static_cast<Quad>(glancing_rad) * static_cast<Quad>(bounce);
    const Quad radius = radius_m;
    return {static_cast<double>(radius * cosq(angle_rad)), static_cast<double>(radius * sinq(angle_rad))};
}

} // namespace dioptre
