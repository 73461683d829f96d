#include "gl/backend.h"

#include <fmt/format.h>

#include <array>
#include <dlfcn.h>

namespace dioptre
{
namespace
{

// What of GL/osmesa.h is used here. The library is loaded at run time: linked beside libGL it breaks by link
// order, and newer Mesa has none.
using Handle = struct osmesa_context*;
using CreateContextAttribs = Handle (*)(const int* attributes, Handle shared);
using DestroyContext = void (*)(Handle);
using MakeCurrent = GLboolean (*)(Handle, void* buffer, GLenum type, GLsizei width, GLsizei height);
using GetCurrentContext = Handle (*)();
constexpr int formatKey = 0x22, rgba = 0x1908, profileKey = 0x33, coreProfile = 0x34, majorKey = 0x36,
              minorKey = 0x37;

struct Library {
    CreateContextAttribs create = nullptr;
    DestroyContext destroy = nullptr;
    MakeCurrent makeCurrent = nullptr;
    GetCurrentContext current = nullptr;
    GLADloadfunc getProcAddress = nullptr;

    bool complete() const
    {
        return create && destroy && makeCurrent && current && getProcAddress;
    }
};

// The library stays loaded for the life of the process (dlopen counts, it does not load twice): LLVM's
// threads and thread-local destructors run on after the context is gone.
Library loadLibrary()
{
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        void* const handle = dlopen(name, RTLD_NOW | RTLD_LOCAL);
        if (handle == nullptr)
            continue;
        Library library;
        library.create = reinterpret_cast<CreateContextAttribs>(dlsym(handle, "OSMesaCreateContextAttribs"));
        library.destroy = reinterpret_cast<DestroyContext>(dlsym(handle, "OSMesaDestroyContext"));
        library.makeCurrent = reinterpret_cast<MakeCurrent>(dlsym(handle, "OSMesaMakeCurrent"));
        library.current = reinterpret_cast<GetCurrentContext>(dlsym(handle, "OSMesaGetCurrentContext"));
        library.getProcAddress = reinterpret_cast<GLADloadfunc>(dlsym(handle, "OSMesaGetProcAddress"));
        if (library.complete())
            return library;
        dlclose(handle);
    }
    return {};
}

class OsMesaContext final : public Context
{
public:
    explicit OsMesaContext(const Library& library) : library_(library)
    {
        info_.backend = "osmesa";
    }
    OsMesaContext(const OsMesaContext&) = delete;
    OsMesaContext& operator=(const OsMesaContext&) = delete;

    ~OsMesaContext() override
    {
        if (handle_ == nullptr)
            return;
        if (library_.current() == handle_)
            library_.makeCurrent(nullptr, nullptr, 0, 0, 0);
        library_.destroy(handle_);
    }

    // Makes the context, makes it current and loads its functions. Gives "" or the fault.
    std::string start()
    {
        const int attributes[] = {formatKey, rgba, profileKey, coreProfile, majorKey, 3, minorKey, 3, 0};
        handle_ = library_.create(attributes, nullptr);
        if (handle_ == nullptr)
            return "OSMesaCreateContextAttribs fails for OpenGL 3.3 core";
        if (!library_.makeCurrent(handle_, window_.data(), GL_UNSIGNED_BYTE, windowSide, windowSide))
            return "OSMesaMakeCurrent fails";
        return loadFunctions(library_.getProcAddress, info_);
    }

private:
    static constexpr int windowSide = 4; // pixels; OSMesa insists on a buffer, all drawing goes into textures

    Library library_;
    Handle handle_ = nullptr;
    std::array<GLubyte, 4 * windowSide * windowSide> window_{};
};

} // namespace

ContextTry tryOsMesa()
{
    const Library library = loadLibrary();
    if (!library.complete())
        return {nullptr, "libOSMesa is not installed"};
    auto context = std::make_unique<OsMesaContext>(library);
    const std::string fault = context->start();
    if (!fault.empty())
        return {nullptr, fault};
    return {std::move(context), ""};
}

} // namespace dioptre
