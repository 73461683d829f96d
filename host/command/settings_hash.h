// One number for all that decides a picture.
#pragma once

#include "command/command.h"
#include "command/picture_drawer.h"

#include <string>

namespace dioptre
{

// 16 hex digits: of what is drawn (see PictureDrawer::sourcesFingerprint()), on what, and of the options that
// change the picture. Equal for all tiles of one picture.
std::string settingsHash(const RenderOptions& options, const ContextInfo& context,
                         unsigned long long sources);

} // namespace dioptre
