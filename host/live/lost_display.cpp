#include "live/lost_display.h"

#include "base/error.h"

#include <cstdio>
#include <cstdlib>
#include <dlfcn.h>

namespace dioptre
{
namespace
{

// Nothing of Xlib may be called any more, and no destructor that would.
int sayAndEnd(struct _XDisplay*)
{
    std::fputs("dioptre: the display went away: start it again where there is one\n", stderr);
    std::_Exit(static_cast<int>(ExitCode::noOpenGl));
}

} // namespace

void endWithTheDisplay()
{
    using Handler = int (*)(struct _XDisplay*);
    using SetHandler = Handler (*)(Handler);
    void* const xlib = dlopen("libX11.so.6", RTLD_NOW | RTLD_NOLOAD);
    if (xlib == nullptr)
        return;
    if (const auto set = reinterpret_cast<SetHandler>(dlsym(xlib, "XSetIOErrorHandler")); set != nullptr)
        set(sayAndEnd);
    dlclose(xlib);
}

} // namespace dioptre
