// What render's options say to a plain shader.
#pragma once

#include "command/command.h"
#include "render/plain.h"

namespace dioptre
{

// Throws usage for options that cannot be read.
PlainSettings plainSettings(const RenderOptions& options);

} // namespace dioptre
