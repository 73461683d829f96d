// What can be drawn again and again on the current context: a scene, or a plain shader.
#pragma once

#include "base/picture.h"
#include "gl/target.h"
#include "render/draw_pacer.h"
#include "render/plan.h"
#include "render/samples.h"
#include "render/source_text.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dioptre
{

// What the making of a drawing took; milliseconds.
struct BuildTimes {
    double load = 0.0;      // assembly and upload
    double compile = 0.0;   // compile and link
    double firstDraw = 0.0; // one pixel: drivers compile here
};

// What is counted in a picture, or in a part of one.
struct PixelCounts {
    double rays = 0.0;         // traced in all samples of all pixels; 0 of a plain shader
    std::size_t nonfinite = 0; // pixels with a channel, alpha apart, that is NaN or infinite
};

// A part of the picture that had a program of its own.
struct DrawnPart {
    std::string name;   // as PicturePart
    double share = 0.0; // of the pixels, 0..1
    std::size_t rectangles = 0;
    Plan plan; // as cut to what the device carries
    SourceText shader;
};

// What a rasterised picture took.
struct RasterFacts {
    int drawn = 0;      // objects
    int culled = 0;     // objects outside the view's frustum
    long triangles = 0; // of the objects that are drawn
    int shadowMaps = 0; // a light that shines all around has six
    int shadowMap_px = 0;
    long shadowMapDraws = 0; // so far; they stay while nothing moves but the eye
};

// What draws, for reports.
struct DrawingFacts {
    SourceText shader;            // of the fullest part; empty where there is no device
    SourceText vertexShader{};    // of what is rasterised; else empty
    std::vector<DrawnPart> parts; // the fullest last; empty where no device drew a scene
    std::size_t textureBytes = 0;
    std::vector<std::string> textures; // sampler uniforms in use
    std::vector<std::string> uniforms; // active, outside blocks
    std::vector<std::string> blocks;   // active uniform blocks
    std::optional<RasterFacts> raster; // where the scene is rasterised
};

class Drawing
{
public:
    Drawing(const Drawing&) = delete;
    Drawing& operator=(const Drawing&) = delete;
    virtual ~Drawing() = default;

    // What is drawn from now on: a part of the picture, no larger than the target, with its corner at
    // multiples of 64 pixels. At first it is the picture's lower left, as far as the target goes.
    void show(const PixelRectangle& region);

    // The most that can be shown at once, in pixels.
    int widthAtOnce() const
    {
        return target_.width;
    }
    int heightAtOnce() const
    {
        return target_.height;
    }

    // Draws all pixels of the region anew, without waiting for the end.
    void submit();

    // The same, and returns when they are done.
    void draw(const Progress& progress = {});

    // The same bit by bit: from nothing, samples are added to a part of the region, and are done on return.
    void start();
    void add(const SampleBatch& batch, const PixelRectangle& area);

    // What holds the sums.
    const AccumulationTarget& target() const
    {
        return target_;
    }

    // What was drawn, as the device holds it, into a float32 picture with the region's corner at (x, y).
    void readInto(Picture& picture, int x, int y) const;
    Picture read() const;

    // Turns what was read into what was asked for. Throws badInput where a driver cut it short.
    virtual PixelCounts finish(Picture& picture) const = 0;

    virtual DrawingFacts facts() const = 0;

    const BuildTimes& times() const
    {
        return times_;
    }

protected:
    // A target of so many pixels, and the time that a draw may take.
    Drawing(int width, int height, double drawLimit_s);

    // Calls cover() until every pixel of the area was drawn once for each batch of samples.
    virtual void drawBatches(std::span<const SampleBatch> batches, const PixelRectangle& area) = 0;

    // Of all the picture's samples.
    virtual std::span<const SampleBatch> batches() const = 0;

    // A target of another size, all of which is shown.
    void resize(int width, int height);

    // Draws, with the program that is current, what of the picture's rectangle is in the region; adds to what
    // is there.
    void cover(const PixelRectangle& area);

    // One pixel, so that the driver compiles.
    void drawFirst();

    // Until such pixels are done.
    void waitForFirst() const;

    PixelRectangle region_;
    BuildTimes times_;

private:
    void submit(const Progress& progress);

    AccumulationTarget target_;
    DrawPacer pacer_;
    double drawLimit_s_;
};

} // namespace dioptre
