// A picture as the file that was asked for.
#pragma once

#include "base/picture_writer.h"
#include "base/tone_curve.h"
#include "command/command.h"
#include "command/video.h"
#include "gl/context.h"
#include "render/view_picture.h"

#include <optional>

namespace dioptre
{

// Throws usage for a picture of no kind that there is, and for options that would have no effect on its kind
// or make no sense with what is drawn: nothing is passed over.
void refuseBadOutput(const RenderOptions& options, bool plainShader);

// What the options ask for; where they ask for nothing, what the scene does.
Display displayOf(const RenderOptions& options, const Display& scene);

// What a picture's file says of itself, but of its view and of how radiance became what a display is sent.
Settings settingsOf(const RenderOptions& options, const ContextInfo& context);

// What a picture is written from beside its numbers.
struct StillForm {
    ContextInfo context;
    std::optional<Display> display;     // none for a plain shader, whose numbers are not encoded
    std::vector<std::string> layers;    // channels beside the colours, in an EXR alone
    const ViewLegend* legend = nullptr; // of what is shown of a view
    bool isShownView = false;           // a PNG is given what is shown of a view
};

// A picture that is written band by band from the top down: all of it or nothing.
class StillWriter
{
public:
    virtual ~StillWriter() = default;

    // Throws cannotWrite, as finish().
    virtual void add(const Picture& band, const std::vector<ExrLayer>& layers) = 0;
    virtual void finish() = 0;
};

// Into the file that the options name, `height` rows of their width.
std::unique_ptr<StillWriter> openStill(const RenderOptions& options, const StillForm& form, int height);

// A frame of a video.
std::unique_ptr<StillWriter> openFrame(Video& video, const StillForm& form);

} // namespace dioptre
