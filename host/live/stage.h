// The picture on the device: it refines itself sample by sample, and gives way to the next only when that is
// there.
#pragma once

#include "live/loaded.h"
#include "live/method_choice.h"
#include "live/painter.h"
#include "render/shown_picture.h"
#include "render/view_picture.h"

#include <memory>
#include <optional>

namespace dioptre
{

// What is known of one of the methods that draw.
struct MethodFacts {
    Method method;
    double sample_ms = 0.0;            // the last one took, all pixels
    std::optional<RasterFacts> raster; // where it rasterises
};

// What is known of the picture that is shown, for people.
struct StageFacts {
    BuildTimes built;                    // of the program, in the window
    std::vector<MethodFacts> methods;    // that draw, the left one first; one of a plain shader
    std::optional<double> raysPerPixel;  // a sample, of a finished picture
    std::size_t nonfinite = 0;           // pixels, of a finished picture
    std::optional<ViewLegend> legend;    // of a view
    bool usesTime = false;               // whether the picture changes with time
    bool usesPointer = false;            // a plain shader's iMouse or u_mouse
    std::vector<std::string> uniforms{}; // active ones of a plain shader
};

class Stage
{
public:
    Stage(const ContextInfo& context, const std::filesystem::path& glslFolder);

    // What is shown; null before the first.
    const Loaded* loaded() const
    {
        return loaded_.get();
    }

    // Shows it from now on. Programs are made anew only where their texts differ. Throws badInput where they
    // cannot be made; then what was shown stays.
    void take(Loaded loaded);

    // Begins the picture anew: at another time, under another camera, in another size.
    void moveTo(const Look& look, double time_s, const PlainFrame& frame);

    // How the pictures of the methods are held against each other. Throws badInput where the shader of
    // facets' edges cannot be made.
    void compare(const MethodChoice& choice);

    // Encodes what was drawn for another display.
    void setDisplay(const std::optional<Display>& display);

    // Draws for about so long; whether there is something new to show.
    bool draw(double budget_ms);

    // Ends the picture as it is, where drawing it failed.
    void giveUp();

    bool isDone() const;
    bool isBegun() const // of the next sample some is drawn
    {
        return row_ > 0 || turn_ > 0;
    }
    int samplesDone() const
    {
        return samplesDone_;
    }

    // Draws what is shown into the window of that size.
    void present(const glm::ivec2& window_px) const;

    // What is shown, of 8 bits, rows from the bottom up; as large as size_px().
    Picture read() const;

    // 0 before the first picture.
    const glm::ivec2& size_px() const
    {
        return shown_.front()->size_px();
    }
    // Of all methods that draw.
    double sample_ms() const;
    const StageFacts& facts() const
    {
        return facts_;
    }

    // Means of the samples so far, as a still has them.
    Picture radiance() const;

private:
    // What draws, its picture as it is shown, and the pace of its drawing.
    struct Layer {
        std::unique_ptr<Painter> painter;
        double msPerRow = 0.0;
        double sample_ms = 0.0;  // of the last that is done
        double drawing_ms = 0.0; // of the one that is begun
    };

    bool isPlain() const
    {
        return loaded_->plain.has_value();
    }
    Comparison comparison() const; // as far as what it takes is there
    int samplesWanted() const;
    void begin();
    void drawRows(double budget_ms);
    void show();
    void finish();
    std::vector<Layer> layersFor(const Loaded& next);
    void updateAll(const Loaded& next, const std::vector<Layer*>& layers);
    void keepShown(const std::vector<Painter*>& before);
    void lookForMotion();
    void lookAtMethods();

    ContextInfo context_;
    std::filesystem::path glslFolder_;
    std::unique_ptr<Loaded> loaded_;                   // the painters point into it
    std::vector<Layer> layers_;                        // by Loaded::drawn
    std::vector<std::unique_ptr<ShownPicture>> shown_; // likewise; one at least
    std::unique_ptr<ShownPicture> difference_;         // while it is shown
    MethodChoice choice_;
    std::optional<Display> display_; // of a scene, once the user has changed it
    StageFacts facts_;
    int samplesDone_ = 0;  // by all layers
    std::size_t turn_ = 0; // the layer that draws the next sample
    int row_ = 0;          // of it, that is drawn next
};

} // namespace dioptre
