// Data beside a picture's colours: what its pixels show, as channels of an EXR.
#pragma once

#include "gl/context.h"
#include "render/renderer.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace dioptre
{

struct LayerRow {
    DataView view;                     // whose numbers it holds
    const char* name;                  // as --layers takes it
    std::vector<const char*> channels; // of the EXR
    const char* holds;                 // in half a sentence
};

// Every layer there is, in the order of the help.
const std::vector<LayerRow>& layerRows();

// The rows of the names, each once, in the order of layerRows(). Throws usage for a name that is not there.
std::vector<LayerRow> layersNamed(const std::vector<std::string>& names);

// Draws them on the current context, with the samples of `view` but for objects, whose numbers have no mean:
// they are those of the sample at the pixel's centre. Depth and normals are the means over the samples that
// meet something, 0 where none does.
class LayerDrawer
{
public:
    LayerDrawer(const Scene& scene, const std::vector<LayerRow>& rows, const ViewSettings& view,
                const ContextInfo& context);

    // Names of the layers that draw() gives.
    std::vector<std::string> channels() const;

    // What making them took.
    BuildTimes times() const;

    // What they are drawn by.
    std::vector<SourceText> shaders() const;

    // Of a rectangle of the picture, as drawStill().
    std::vector<ExrLayer> draw(const PixelRectangle& region) const;

private:
    struct DrawnView {
        std::unique_ptr<PreparedScene> prepared; // stays where the renderer looks for it
        std::unique_ptr<Renderer> renderer;
    };

    Picture sumsOf(DataView view, const PixelRectangle& region) const;

    std::vector<LayerRow> rows_;
    std::map<DataView, DrawnView> views_;
};

} // namespace dioptre
