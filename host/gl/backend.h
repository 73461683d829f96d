// One function for each way to a context, and what they share.
#pragma once

#include "gl/context.h"

#include <glad/gl.h>

#include <memory>
#include <string>

namespace dioptre
{

// A context that is current, or the reason why there is none.
struct ContextTry {
    std::unique_ptr<Context> context;
    std::string fault; // "" when it worked
    std::string mend = packagesForOpenGl;
    bool absent = false; // nothing is broken: the machine, as it is set up, does not have it
};

ContextTry tryEglSurfaceless();
ContextTry tryEglDevice();

// Whether one of EGL's devices is not the software rasteriser.
bool eglListsGraphicsCard();
ContextTry tryEglDefault();
ContextTry tryOsMesa();
ContextTry tryWindow();

// Loads the OpenGL functions of the context that is current and fills the rest of `info`. Gives "" or the
// fault: functions loaded for another context crash, so this runs for every new one.
std::string loadFunctions(GLADloadfunc loader, ContextInfo& info);

} // namespace dioptre
