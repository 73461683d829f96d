// What render's options say to a plain shader.
#pragma once

#include "command/command.h"
#include "render/plain.h"

namespace dioptre
{

// Throws usage for options that cannot be read.
PlainSettings plainSettings(const RenderOptions& options);
PlainValues plainValues(const std::vector<std::string>& entries); // each NAME=VALUE

} // namespace dioptre
