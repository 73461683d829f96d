#include "gl/backend.h"

#include "base/text.h"

#define EGL_NO_X11 // no X headers: their macros collide with ordinary names
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace dioptre
{
namespace
{

// `extensions` may be null, which is how EGL says that it cannot tell.
bool lists(const char* extensions, std::string_view wanted)
{
    return fmt::format(" {} ", extensions != nullptr ? extensions : "").find(fmt::format(" {} ", wanted)) !=
           std::string::npos;
}

bool clientHas(std::string_view extension)
{
    return lists(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), extension);
}

std::string eglFault(std::string_view call)
{
    return fmt::format("{} fails (EGL error 0x{:04x})", call, eglGetError());
}

// Holds whatever start() got hold of, so that a start that stops half-way is undone by the destructor as
// well. Ending the display ends every other context of the same backend: one at a time.
class EglContext final : public Context
{
public:
    EglContext(std::string backend, EGLDisplay display) : display_(display)
    {
        info_.backend = std::move(backend);
    }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    ~EglContext() override
    {
        if (context_ != EGL_NO_CONTEXT && eglGetCurrentContext() == context_)
            eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        if (context_ != EGL_NO_CONTEXT)
            eglDestroyContext(display_, context_);
        if (surface_ != EGL_NO_SURFACE)
            eglDestroySurface(display_, surface_);
        eglTerminate(display_);
        if (eglGetCurrentContext() == EGL_NO_CONTEXT)
            eglReleaseThread();
    }

    // Makes the context, makes it current and loads its functions. Gives "" or the fault.
    std::string start()
    {
        if (!eglInitialize(display_, nullptr, nullptr))
            return eglFault("eglInitialize");
        if (!eglBindAPI(EGL_OPENGL_API))
            return eglFault("eglBindAPI");
        const bool needsSurface =
            !lists(eglQueryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context");
        const EGLConfig config = chooseConfig(needsSurface);
        if (config == nullptr)
            return "no EGL configuration can do OpenGL";
        const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION,
                                  3,
                                  EGL_CONTEXT_MINOR_VERSION,
                                  3,
                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                  EGL_NONE};
        context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
        if (context_ == EGL_NO_CONTEXT)
            return eglFault("eglCreateContext for OpenGL 3.3 core");
        if (needsSurface) {
            const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
            surface_ = eglCreatePbufferSurface(display_, config, size);
        }
        if (!eglMakeCurrent(display_, surface_, surface_, context_))
            return eglFault("eglMakeCurrent");
        return loadFunctions(eglGetProcAddress, info_);
    }

private:
    // Colour and depth do not matter: all drawing goes into textures.
    EGLConfig chooseConfig(bool needsSurface) const
    {
        const EGLint wanted[] = {EGL_SURFACE_TYPE, needsSurface ? EGL_PBUFFER_BIT : 0, EGL_RENDERABLE_TYPE,
                                 EGL_OPENGL_BIT, EGL_NONE};
        EGLConfig config = nullptr;
        EGLint count = 0;
        return eglChooseConfig(display_, wanted, &config, 1, &count) && count > 0 ? config : nullptr;
    }

    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
    EGLSurface surface_ = EGL_NO_SURFACE;
};

ContextTry tryDisplay(const std::string& backend, EGLDisplay display)
{
    if (display == EGL_NO_DISPLAY)
        return {nullptr, "EGL gives no display"};
    auto context = std::make_unique<EglContext>(backend, display);
    const std::string fault = context->start();
    if (!fault.empty())
        return {nullptr, fault};
    return {std::move(context), ""};
}

template <typename Function>
Function eglFunction(const char* name)
{
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

EGLDisplay platformDisplay(EGLenum platform, void* native)
{
    const auto getPlatformDisplay = eglFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    return getPlatformDisplay != nullptr ? getPlatformDisplay(platform, native, nullptr) : EGL_NO_DISPLAY;
}

std::vector<EGLDeviceEXT> devices()
{
    const auto queryDevices = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (queryDevices == nullptr || !queryDevices(0, nullptr, &count) || count <= 0)
        return {};
    std::vector<EGLDeviceEXT> found(static_cast<std::size_t>(count));
    if (!queryDevices(count, found.data(), &count))
        return {};
    found.resize(static_cast<std::size_t>(count));
    return found;
}

} // namespace

bool eglListsGraphicsCard()
{
    const auto queryString = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return queryString != nullptr && std::ranges::any_of(devices(), [&](EGLDeviceEXT device) {
               return !lists(queryString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
           });
}

ContextTry tryEglSurfaceless()
{
    if (!clientHas("EGL_MESA_platform_surfaceless"))
        return {nullptr, "EGL has no surfaceless platform"};
    return tryDisplay("egl-surfaceless", platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY));
}

// The first device that works: EGL lists graphics cards before the software rasteriser.
ContextTry tryEglDevice()
{
    if (!clientHas("EGL_EXT_platform_device"))
        return {nullptr, "EGL has no device platform"};
    std::vector<std::string> faults;
    for (EGLDeviceEXT device : devices()) {
        ContextTry attempt = tryDisplay("egl-device", platformDisplay(EGL_PLATFORM_DEVICE_EXT, device));
        if (attempt.context != nullptr)
            return attempt;
        faults.push_back(fmt::format("device {}: {}", faults.size(), attempt.fault));
    }
    return {nullptr, faults.empty() ? "EGL lists no devices" : join(faults, ", ")};
}

ContextTry tryEglDefault()
{
    return tryDisplay("egl-default", eglGetDisplay(EGL_DEFAULT_DISPLAY));
}

} // namespace dioptre
