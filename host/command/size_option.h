// The --size of a picture, as several commands take it.
#pragma once

#include <string>

namespace dioptre
{

// "640x360" to two numbers of pixels. Throws usage.
void readSize(const std::string& text, int& width, int& height);

} // namespace dioptre
