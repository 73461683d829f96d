// From a scene to a picture, with the time of each step.
#pragma once

#include "base/picture.h"
#include "gl/context.h"
#include "render/prepare.h"
#include "render/source_text.h"

#include <filesystem>
#include <functional>
#include <string>

namespace dioptre
{

struct StillSettings : ViewSettings {
    std::function<void(double)> progress; // told the share that is drawn, 0..1; may be empty
};

// Milliseconds by a monotonic clock, one after the other; a draw is over when glFinish returns.
struct Phases {
    double context = 0.0;   // pictures are loaded beside it, by other threads
    double load = 0.0;      // scene, what is left of the pictures when the context is made, assembly, upload
    double compile = 0.0;   // compile and link
    double firstDraw = 0.0; // one pixel: drivers compile here
    double draw = 0.0;      // all samples of all pixels
    double read = 0.0;      // back to memory
    double write = 0.0;     // encode and write the file
    double total = 0.0;     // of the whole command; the context's end is part of it and of no phase above
};

// A part of the picture that had a program of its own.
struct DrawnPart {
    std::string name;   // as PicturePart
    double share = 0.0; // of the pixels, 0..1
    std::size_t rectangles = 0;
    Plan plan; // as cut to what the device carries
    SourceText shader;
};

struct Still {
    Picture
        picture; // float32, mean of the samples, rows from the bottom up; a scene's alpha is 1; a view's data
    double raysPerSample = 0.0;
    std::size_t nonfinite = 0; // pixels with a channel that is NaN or infinite
    Phases phases;
    SourceText shader;            // of the fullest part
    std::vector<DrawnPart> parts; // the fullest last; empty where no device drew a scene
    std::size_t textureBytes = 0;
    std::vector<std::string> textures; // sampler uniforms in use
    std::vector<std::string> uniforms; // active, outside blocks
    std::vector<std::string> blocks;   // active uniform blocks
};

// Draws on the current context. Throws badInput with the author's file and line when the shader does not
// compile.
Still renderScene(const PreparedScene& prepared, const StillSettings& settings, const ContextInfo& context);

class Renderer;

// The picture alone of a scene that is on the device, for one frame of many: without the program's texts and
// names. `settings` are the renderer's.
Still drawFrame(Renderer& renderer, const StillSettings& settings);

// Turns the rays counted in alpha into raysPerSample, alpha into 1, and counts pixels that are not finite.
// The colours are multiplied by `scale`.
void finish(Still& still, float scale, double raysScale);

// Pixels with a channel, alpha apart, that is NaN or infinite.
std::size_t countNonfinite(const Picture& picture);

} // namespace dioptre
