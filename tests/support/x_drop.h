// Dropping files into a window, as a file manager does.
#pragma once

#include "support/x_driver.h"

#include <filesystem>

namespace dioptre::test
{

// Speaks XDND version 5 (https://www.freedesktop.org/wiki/Specifications/XDND) as the source until the window
// says that it is done. Throws where it says nothing within some seconds, or takes no files.
void drop(XDriver& driver, const std::vector<std::filesystem::path>& files);

} // namespace dioptre::test
