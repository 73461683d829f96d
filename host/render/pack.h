// From a scene in the author's terms to numbers in the scene frame.
#pragma once

#include "base/picture_cache.h"
#include "render/plan.h"

namespace dioptre
{

// What the picture's size and the number of samples decide.
struct View {
    int height = 0;  // pixels
    int samples = 1; // a pixel
};

// The world position that becomes the scene frame's origin: the world's own while the camera is near it, else
// a point of a coarse grid near the eye, so that floats keep their digits where the scene is.
glm::dvec3 sceneOrigin(const Scene& scene);

// Whether the origin may stay there under this camera: within two steps of its grid along each axis. Its own
// lies within half of one, so that floats lose two bits of 24.
bool originServes(const glm::dvec3& origin, const Camera& camera);

// Everything but the pictures' contents and the cut-off, which depends on them. Material and light indices
// are those of the plan's lists.
PackedScene pack(const Scene& scene, const Plan& plan, const View& view);

// packed::MODEL_ of a material's model.
int modelOf(ReflectanceModel model);

// Geometry of one object, with kind and texture frame; material is left 0.
PackedObject packShape(const Object& object, const glm::dvec3& origin);

// The largest radiance that a path may still find, so that cutting weight * brightest < cut_off stays
// invisible: max(1, `sky`, emission colours, each light's colour at its nearest distance to an object, not
// below 1 % of the scene's size).
double brightestRadiance(const Scene& scene, const Plan& plan, double sky);

// Decodes the pictures that the plan samples, and the sky's, or takes them from the cache. Throws badInput
// where a texel is NaN.
void loadPictures(const Scene& scene, const Plan& plan, PackedScene& packed, const PictureCache& cache = {});

// The same of the sky's alone.
void loadSkyPicture(const Scene& scene, const Plan& plan, PackedScene& packed, const PictureCache& cache);

// The smallest weight of a path that is traced: trace.cut_off over the brightest radiance, the loaded sky's
// included.
void setCutOff(const Scene& scene, const Plan& plan, PackedScene& packed);

} // namespace dioptre
