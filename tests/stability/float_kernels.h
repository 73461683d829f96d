// Ray and sphere in float as textbooks have it, and a better form: for the suite to fail and to pass.
#pragma once

#include "stability/judge.h"

#include <cmath>

namespace dioptre
{

inline DeviceAnswer answerOf(const RayProblem& problem, bool found, float near, float far)
{
    const glm::vec3 centre(problem.p[0], problem.p[1], problem.p[2]);
    const float t = near > 0.0F ? near : far;
    DeviceAnswer answer;
    answer.hit = found && t > 0.0F;
    if (!answer.hit)
        return answer;
    answer.t = static_cast<double>(t);
    answer.normal = glm::dvec3(glm::vec3(problem.origin) + t * glm::vec3(problem.direction) - centre);
    return answer;
}

// (-b +- sqrt(b^2 - 4ac)) / 2a, and the normal P - c.
inline DeviceAnswer textbookSphere(const RayProblem& problem)
{
    const glm::vec3 direction(problem.direction);
    const auto radius = static_cast<float>(problem.p[3]);
    const glm::vec3 f = glm::vec3(problem.origin) - glm::vec3(problem.p[0], problem.p[1], problem.p[2]);
    const float a = glm::dot(direction, direction);
    const float b = 2.0F * glm::dot(f, direction);
    const float c = glm::dot(f, f) - radius * radius;
    const float discriminant = b * b - 4.0F * a * c;
    const float root = std::sqrt(std::max(discriminant, 0.0F));
    return answerOf(problem, discriminant >= 0.0F, (-b - root) / (2.0F * a), (-b + root) / (2.0F * a));
}

// Haines, Guenther, Akenine-Moeller, Ray Tracing Gems, ch. 7, and the normal in the centre's frame.
inline DeviceAnswer hainesSphere(const RayProblem& problem)
{
    const glm::vec3 direction(problem.direction);
    const auto radius = static_cast<float>(problem.p[3]);
    const glm::vec3 f = glm::vec3(problem.origin) - glm::vec3(problem.p[0], problem.p[1], problem.p[2]);
    const float a = glm::dot(direction, direction);
    const float b = -glm::dot(f, direction) / a;
    const glm::vec3 h = f + b * direction;
    const float apart = glm::length(h);
    const float discriminant = (radius - apart) * (radius + apart);
    const float root = std::sqrt(std::max(discriminant, 0.0F) / a);
    const float larger = b >= 0.0F ? b + root : b - root;
    const float smaller =
        larger == 0.0F ? 0.0F : (glm::length(f) - radius) * (glm::length(f) + radius) / (a * larger);
    const float near = std::min(smaller, larger);
    DeviceAnswer answer = answerOf(problem, discriminant >= 0.0F, near, std::max(smaller, larger));
    answer.normal = glm::dvec3(near > 0.0F ? h - root * direction : h + root * direction);
    return answer;
}

// Curvature form, for the surface through the origin with the normal +y there; Spencer and
// Murty, "General ray-tracing procedure", 1962. A = half the curvature, B and C from the point nearest to the
// origin.
inline DeviceAnswer curvedGround(const RayProblem& problem)
{
    const glm::vec3 w(problem.origin);
    const glm::vec3 direction(problem.direction);
    const glm::vec3 up(0.0F, 1.0F, 0.0F);
    const float curvature = 1.0F / static_cast<float>(problem.p[3]);
    const float a = 0.5F * curvature * glm::dot(direction, direction);
    const float b = curvature * glm::dot(w, direction) + glm::dot(up, direction);
    const float c = 0.5F * curvature * glm::dot(w, w) + glm::dot(up, w);
    const float discriminant = b * b - 4.0F * a * c;
    const float root = std::sqrt(std::max(discriminant, 0.0F));
    const float q = -0.5F * (b + (b >= 0.0F ? root : -root));
    DeviceAnswer answer =
        answerOf(problem, discriminant >= 0.0F, std::min(q / a, c / q), std::max(q / a, c / q));
    answer.normal = glm::dvec3(up + curvature * (w + static_cast<float>(answer.t) * direction));
    return answer;
}

} // namespace dioptre
