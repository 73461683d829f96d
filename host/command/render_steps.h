// Steps of the render command that a still and the frames of an animation share.
#pragma once

#include "command/command.h"
#include "command/input.h"
#include "render/still.h"
#include "render/view_picture.h"

namespace dioptre
{

// Options that would have no effect, or no sense, are refused, not passed over.
void refuseBadOptions(const RenderOptions& options, const Input& input);

// What the size, the samples, the view and the place of the sources are.
StillSettings stillSettingsOf(const RenderOptions& options);

// In double precision on the CPU: the same sources, no OpenGL.
Still renderReferenceStill(const PreparedScene& prepared, const StillSettings& settings);

} // namespace dioptre
