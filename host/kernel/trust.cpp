#include "kernel/trust.h"

#include "base/interruption.h"
#include "base/parallel.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <cmath>

namespace dioptre
{
namespace trust
{

#define HAS_TRUST

// Nothing is lit here: these two keep parameters from going unused.
#define HAS_SHADOW_ABSORPTION
#define HAS_SKY_GRADIENT

#include "kernel/glsl_as_cpp.h"

static const std::vector<PackedObject>* objects;

// On the device it stands in the generated text.
static bool hasOwnKernel(int object)
{
    return (*objects)[static_cast<std::size_t>(object)].apart;
}

#include "kernel/tracer_as_cpp.h"

} // namespace trust

Picture accountOfTrust(const PackedScene& scene, int width, int height, int samples,
                       const PixelRectangle& region)
{
    const ShapeTable table = plainShapeTable(scene);
    trust::setTracer(scene, table, width, height);
    trust::u_cut_off = std::max(scene.cutOff, packed::TRUSTED_WEIGHT);
    trust::objects = &scene.objects;
    return trust::traceRegion(scene, samples, region);
}

double shareBeyondTrust(const PackedScene& scene, double width, double height)
{
    // Fewer where each may ask for much.
    constexpr double most = 2500.0, least = 100.0, crossings = 5e7;
    const double each =
        std::max(1.0, static_cast<double>(scene.budget) * static_cast<double>(scene.objects.size()));
    const double pixels = std::clamp(crossings / each, least, most);
    const int columns = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels * width / height))));
    const int rows = std::max(1, static_cast<int>(std::lround(std::sqrt(pixels * height / width))));
    if (scene.objects.empty())
        return 0.0;
    const Picture account = accountOfTrust(scene, columns, rows, 1, {0, 0, columns, rows});
    double beyond = 0.0;
    for (std::size_t i = 0; i < account.floats.size(); i += 4)
        beyond += static_cast<double>(account.floats[i]);
    return beyond / (static_cast<double>(columns) * rows);
}

} // namespace dioptre
