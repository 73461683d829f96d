// Pictures for tests, without the command line.
#pragma once

#include "base/search_places.h"
#include "gl/context.h"
#include "render/drawing.h"
#include "render/prepare.h"
#include "render/still.h"

#include <string>
#include <vector>

namespace dioptre::test
{

struct Request {
    int width = 64;
    int height = 48;
    int samples = 1;
    std::vector<std::string> overrides; // as --set
    std::string backend = "auto";
    double time_s = 0.0;
    DataView view = DataView::none;
    std::string method = "trace"; // as --method
};

// A picture, and what drew it.
struct Rendered : DrawingFacts {
    Picture picture;
    PixelCounts counts;
    double raysPerSample = 0.0;
};

// glsl/ of the sources, or $DIOPTRE_GLSL where set: mutants put their own there.
std::filesystem::path glslFolder();

// Where the gallery's scenes find their pictures.
SearchPlaces places();

// The gallery's scenes, sorted by name.
std::vector<std::filesystem::path> galleryScenes();

// Overrides that put our own painted planet in place of the earth, which a machine may have or not have.
std::vector<std::string> ownPictures(const std::filesystem::path& scene);

// On the device; one context is kept between calls and remade when the backend changes.
Rendered renderScene(const std::filesystem::path& scene, const Request& request);
Rendered renderSceneText(const std::string& toml, const Request& request);

Rendered renderPrepared(const PreparedScene& prepared, const ViewSettings& settings,
                        const std::string& backend);

// In double precision by the reference.
Picture renderDouble(const std::filesystem::path& scene, const Request& request);

Picture renderDoubleText(const std::string& toml, const Request& request);

// The scene's pictures at several moments, drawn one after the other by the same programs, by a method that
// rasterises.
std::vector<Rendered> rasteriseMoments(const std::filesystem::path& scene, const Request& request,
                                       const std::vector<double>& moments_s);

// The context that the calls above draw on.
const ContextInfo& contextFor(const std::string& backend);

} // namespace dioptre::test
