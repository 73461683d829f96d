// The picture on the device: it refines itself sample by sample, and gives way to the next only when that is
// there.
#pragma once

#include "live/loaded.h"
#include "render/renderer.h"
#include "render/shown_picture.h"
#include "render/view_picture.h"

#include <memory>
#include <optional>

namespace dioptre
{

// What is known of the picture that is shown, for people.
struct StageFacts {
    BuildTimes built;                    // of the program, in the window
    double sample_ms = 0.0;              // the last one took, all pixels
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

    // Encodes what was drawn for another display.
    void setDisplay(const std::optional<Display>& display);

    // Draws for about so long; whether there is something new to show.
    bool draw(double budget_ms);

    // Ends the picture as it is, where drawing it failed.
    void giveUp();

    bool isDone() const;
    bool isBegun() const // of the next sample some is drawn
    {
        return row_ > 0;
    }
    int samplesDone() const
    {
        return samplesDone_;
    }

    const ShownPicture& shown() const
    {
        return shown_;
    }
    const StageFacts& facts() const
    {
        return facts_;
    }

    // Means of the samples so far, as a still has them.
    Picture radiance() const;

private:
    Drawing& drawing() const;
    int samplesWanted() const;
    void begin();
    void show();
    void finish();
    void takeTexts(std::unique_ptr<Loaded> loaded);
    void takeValues(std::unique_ptr<Loaded> loaded);
    void lookForMotion();

    ContextInfo context_;
    ShownPicture shown_;
    std::unique_ptr<Loaded> loaded_; // the renderer points into it
    std::unique_ptr<Renderer> scene_;
    std::unique_ptr<PlainRenderer> plain_;
    std::optional<Display> display_; // of a scene, once the user has changed it
    StageFacts facts_;
    int samplesDone_ = 0;
    int row_ = 0; // of the next sample, that is drawn next
    double msPerRow_ = 0.0;
    double sample_ms_ = 0.0;
};

} // namespace dioptre
