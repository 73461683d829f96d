// The frames of an animation, to numbered pictures or to a video.
#pragma once

#include "command/command.h"
#include "command/input.h"

namespace dioptre
{

// As `options.frames` asks; the other options are good for a still.
ExitCode renderFrames(const RenderOptions& options, const Input& input);

} // namespace dioptre
