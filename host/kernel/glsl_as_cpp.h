// The part of GLSL that glsl/ uses, in C++ and in double precision. Plain overloads in place of GLM's
// templates, so that swizzles convert on the way in. Include inside the namespace that takes the shader
// sources. NOLINTBEGIN: no include guard, this is a fragment

using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;

inline double abs(double x)
{
    return std::fabs(x);
}
inline double sqrt(double x)
{
    return std::sqrt(x);
}
inline double exp(double x)
{
    return std::exp(x);
}
inline double log(double x)
{
    return std::log(x);
}
inline double log2(double x)
{
    return std::log2(x);
}
inline double exp2(double x)
{
    return std::exp2(x);
}
inline double pow(double x, double y)
{
    return std::pow(x, y);
}
inline double floor(double x)
{
    return std::floor(x);
}
inline double ceil(double x)
{
    return std::ceil(x);
}
inline double fract(double x)
{
    return x - std::floor(x);
}
inline double mod(double x, double y)
{
    return x - y * std::floor(x / y);
}
inline double atan(double y, double x)
{
    return std::atan2(y, x);
}
inline int max(int a, int b)
{
    return a < b ? b : a;
}
inline double min(double a, double b)
{
    return b < a ? b : a;
}
inline double max(double a, double b)
{
    return a < b ? b : a;
}
inline double clamp(double x, double low, double high)
{
    return min(max(x, low), high);
}

inline vec2 fract(vec2 v)
{
    return glm::fract(v);
}
inline vec3 exp(vec3 v)
{
    return glm::exp(v);
}
inline vec3 min(vec3 a, vec3 b)
{
    return glm::min(a, b);
}
inline double dot(vec2 a, vec2 b)
{
    return glm::dot(a, b);
}
inline double dot(vec3 a, vec3 b)
{
    return glm::dot(a, b);
}
inline vec3 cross(vec3 a, vec3 b)
{
    return glm::cross(a, b);
}
inline double length(vec2 v)
{
    return glm::length(v);
}
inline double length(vec3 v)
{
    return glm::length(v);
}
inline vec3 normalize(vec3 v)
{
    return v / glm::length(v);
}
inline vec3 reflect(vec3 i, vec3 n)
{
    return i - 2.0 * glm::dot(n, i) * n;
}
inline vec3 mix(vec3 a, vec3 b, double t)
{
    return a * (1.0 - t) + b * t;
}

// GLM negates vectors but not swizzles.
template <int N, typename T, glm::qualifier Q, int A, int B, int C, int D>
glm::vec<N, T, Q> operator-(const glm::detail::_swizzle<N, T, Q, A, B, C, D>& swizzle)
{
    return -glm::vec<N, T, Q>(swizzle());
}

// NOLINTEND
