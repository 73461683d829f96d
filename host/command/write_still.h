// A finished picture as the file that was asked for.
#pragma once

#include "base/tone_curve.h"
#include "command/command.h"
#include "render/still.h"
#include "render/view_picture.h"

namespace dioptre
{

// Throws usage for a picture of no kind that there is, and for options that would have no effect on its kind
// or make no sense with what is drawn: nothing is passed over.
void refuseBadOutput(const RenderOptions& options, bool plainShader);

// What the options ask for; where they ask for nothing, what the scene does.
Display displayOf(const RenderOptions& options, const Display& scene);

// What a picture is written from beside its numbers.
struct StillContent {
    const Still& still;
    const ContextInfo& context;
    const Display* display = nullptr;    // null for a plain shader, whose numbers are not encoded
    const ShownView* shown = nullptr;    // what a PNG holds of a view, else null; other kinds hold its data
    const std::vector<ExrLayer>& layers; // beside the colours, in an EXR alone
};

// What a picture's file says of itself, but of its view and of how radiance became what a display is sent.
Settings settingsOf(const RenderOptions& options, const ContextInfo& context);

// The pixels of an 8-bit PNG of it: R, G, B, rows from the top down.
std::vector<std::uint8_t> displayedBytes(const StillContent& content);

// Throws cannotWrite.
void writeStill(const RenderOptions& options, const StillContent& content);

} // namespace dioptre
