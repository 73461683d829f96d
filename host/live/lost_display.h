// What happens when the X server goes away under a window.
#pragma once

namespace dioptre
{

// Xlib would end the process with code 1 and words of its own: it ends with a message and as where there is
// no display. To be called when GLFW has started; without Xlib it does nothing.
void endWithTheDisplay();

} // namespace dioptre
