// Steps of the render command that a still and the frames of an animation share.
#pragma once

#include "command/command.h"
#include "command/input.h"

#include <functional>

namespace dioptre
{

// Options that would have no effect, or no sense, are refused, not passed over.
void refuseBadOptions(const RenderOptions& options, const Input& input);

// Works until the end or until a signal is noted (see Interruption) and comes to be heard. Gives the signal,
// 0 for none.
int signalDuring(const std::function<void()>& work);

} // namespace dioptre
