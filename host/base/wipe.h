// Two pictures in one, for the eye to compare along a line between them.
#pragma once

#include "base/picture.h"

#include <string>

namespace dioptre
{

// The columns below `share` (0..1) of the width from the left picture, the others from the right one, with a
// thin light line between that has dark edges, so that it is seen on any ground. The titles stand in the
// upper corners, each as far as its part has place for it. Pictures of any format, as on a contact sheet;
// gives srgb8. Throws badInput where they differ in size, and as Lettering does.
Picture wiped(const Picture& left, const Picture& right, double share, const std::string& leftTitle,
              const std::string& rightTitle);

} // namespace dioptre
