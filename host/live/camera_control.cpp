#include "live/camera_control.h"

#include "scene/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dioptre
{
namespace
{

// From the pole: the picture's up must stay defined.
constexpr double leastPolar_rad = 0.01;

// An offset turned about +y and towards it.
glm::dvec3 rotated(const glm::dvec3& offset, double azimuth_rad, double elevation_rad)
{
    const double length = glm::length(offset);
    const double azimuth = std::atan2(offset.x, offset.z) + azimuth_rad;
    const double most = 0.5 * std::numbers::pi - leastPolar_rad;
    const double elevation =
        std::clamp(std::asin(std::clamp(offset.y / length, -1.0, 1.0)) + elevation_rad, -most, most);
    return length * glm::dvec3(std::sin(azimuth) * std::cos(elevation), std::sin(elevation),
                               std::cos(azimuth) * std::cos(elevation));
}

// Twelve digits: more than a hand can place, in scenes of any size.
std::string shortNumber(double number)
{
    std::string text = fmt::format("{:.12g}", number);
    if (text.find_first_of(".e") == std::string::npos)
        text += ".0";
    return text == "-0.0" ? "0.0" : text;
}

glm::dvec3 rounded(const glm::dvec3& v)
{
    return {std::stod(shortNumber(v.x)), std::stod(shortNumber(v.y)), std::stod(shortNumber(v.z))};
}

std::string listOf(const glm::dvec3& v)
{
    return fmt::format("[{}, {}, {}]", shortNumber(v.x), shortNumber(v.y), shortNumber(v.z));
}

} // namespace

Camera orbited(Camera camera, double right_rad, double up_rad)
{
    camera.eye = camera.target + rotated(camera.eye - camera.target, -right_rad, -up_rad);
    return camera;
}

Camera turned(Camera camera, double right_rad, double up_rad)
{
    camera.target = camera.eye + rotated(camera.target - camera.eye, -right_rad, up_rad);
    return camera;
}

Camera panned(Camera camera, double right, double up)
{
    const glm::dmat3 frame = worldFromCamera(camera);
    const double height_m = 2.0 * glm::distance(camera.eye, camera.target) *
                            std::tan(0.5 * camera.fovY_deg * std::numbers::pi / 180.0);
    const glm::dvec3 move = height_m * (right * frame[0] + up * frame[1]);
    camera.eye += move;
    camera.target += move;
    return camera;
}

Camera flown(Camera camera, const glm::dvec3& rightUpAhead_m)
{
    const glm::dmat3 frame = worldFromCamera(camera);
    const glm::dvec3 move = rightUpAhead_m.x * frame[0] + rightUpAhead_m.y * glm::dvec3(0.0, 1.0, 0.0) -
                            rightUpAhead_m.z * frame[2];
    camera.eye += move;
    camera.target += move;
    return camera;
}

// By the picture's height, so that every notch looks alike.
Camera zoomed(Camera camera, double notches)
{
    const double half_rad = 0.5 * camera.fovY_deg * std::numbers::pi / 180.0;
    const double zoomed_rad = std::atan(std::tan(half_rad) * std::pow(1.1, -notches));
    camera.fovY_deg = std::clamp(2.0 * zoomed_rad * 180.0 / std::numbers::pi, 1.0, 170.0);
    return camera;
}

Camera rounded(Camera camera)
{
    camera.eye = rounded(camera.eye);
    camera.target = rounded(camera.target);
    camera.fovY_deg = std::stod(shortNumber(camera.fovY_deg));
    return camera;
}

std::string tomlOf(const Camera& camera)
{
    return fmt::format("[camera]\neye = {}\ntarget = {}\nfov_y_deg = {}\n", listOf(camera.eye),
                       listOf(camera.target), shortNumber(camera.fovY_deg));
}

std::vector<std::string> overridesOf(const Camera& camera)
{
    return {"camera.eye=" + listOf(camera.eye), "camera.target=" + listOf(camera.target),
            "camera.fov_y_deg=" + shortNumber(camera.fovY_deg)};
}

} // namespace dioptre
