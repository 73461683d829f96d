// Steps of the render command that a still and the frames of an animation share.
#pragma once

#include "command/command.h"
#include "command/input.h"

namespace dioptre
{

// Options that would have no effect, or no sense, are refused, not passed over.
void refuseBadOptions(const RenderOptions& options, const Input& input);

} // namespace dioptre
