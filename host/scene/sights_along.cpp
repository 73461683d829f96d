#include "scene/sights_along.h"

#include <cmath>
#include <type_traits>

namespace dioptre
{
namespace
{

// Part of the way from one shape of a kind to another.
class Between
{
public:
    explicit Between(double share) : share_(share) {}

    glm::dvec3 operator()(const glm::dvec3& a, const glm::dvec3& b) const
    {
        return glm::mix(a, b, share_);
    }
    double operator()(double a, double b) const
    {
        return std::lerp(a, b, share_);
    }
    Sphere operator()(const Sphere& a, const Sphere& b) const
    {
        return {(*this)(a.centre, b.centre), (*this)(a.radius, b.radius)};
    }
    Cylinder operator()(const Cylinder& a, const Cylinder& b) const
    {
        return {(*this)(a.base, b.base), (*this)(a.axis, b.axis), (*this)(a.radius, b.radius), a.capped};
    }
    Plane operator()(const Plane& a, const Plane& b) const
    {
        return {(*this)(a.point, b.point), (*this)(a.normal, b.normal), a.rasterExtent_m};
    }
    Disk operator()(const Disk& a, const Disk& b) const
    {
        return {(*this)(a.centre, b.centre), (*this)(a.normal, b.normal), (*this)(a.radius, b.radius)};
    }
    Rectangle operator()(const Rectangle& a, const Rectangle& b) const
    {
        return {(*this)(a.corner, b.corner), (*this)(a.edgeU, b.edgeU), (*this)(a.edgeV, b.edgeV)};
    }
    Triangle operator()(const Triangle& a, const Triangle& b) const
    {
        return {(*this)(a.a, b.a), (*this)(a.b, b.b), (*this)(a.c, b.c)};
    }
    Primitive operator()(const Primitive& a, const Primitive& b) const
    {
        return std::visit(
            [&](const auto& from) -> Primitive {
                return (*this)(from, std::get<std::decay_t<decltype(from)>>(b));
            },
            a);
    }
    Sight operator()(const Sight& a, const Sight& b) const
    {
        Sight sight = a;
        sight.camera.eye = (*this)(a.camera.eye, b.camera.eye);
        sight.camera.fovY_deg = (*this)(a.camera.fovY_deg, b.camera.fovY_deg);
        for (std::size_t i = 0; i < sight.moving.size(); ++i)
            sight.moving[i] = (*this)(a.moving[i], b.moving[i]);
        return sight;
    }

private:
    double share_;
};

} // namespace

std::vector<Sight> sightsAlong(const std::vector<Sight>& keys)
{
    constexpr int steps = 8;
    std::vector<Sight> sights{keys.front()};
    for (std::size_t key = 1; key < keys.size(); ++key) {
        for (int i = 1; i < steps; ++i)
            sights.push_back(Between(static_cast<double>(i) / steps)(keys[key - 1], keys[key]));
        sights.push_back(keys[key]);
    }
    return sights;
}

} // namespace dioptre
