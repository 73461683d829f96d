#include "gl/context.h"

#include "base/error.h"
#include "base/text.h"
#include "gl/backend.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace dioptre
{
namespace
{

struct Backend {
    const char* name;
    ContextTry (*attempt)();
};

// In the order in which "auto" tries them.
constexpr std::array<Backend, 4> backends{{{"egl-surfaceless", tryEglSurfaceless},
                                           {"egl-device", tryEglDevice},
                                           {"egl-default", tryEglDefault},
                                           {"osmesa", tryOsMesa}}};

bool answersTo(const Backend& backend, const std::string& request)
{
    const std::string name = backend.name;
    return request == "auto" || request == name || (request == "egl" && name.starts_with("egl-"));
}

std::string glText(GLenum which)
{
    const auto* const text = reinterpret_cast<const char*>(glGetString(which));
    return text != nullptr ? text : "";
}

[[noreturn]] void failUnknown(const std::string& request)
{
    const std::string nearest = nearestWord(request, backendNames());
    fail(ExitCode::usage, fmt::format("there is no backend '{}'", request),
         nearest.empty() ? fmt::format("choose one of {}", join(backendNames(), ", "))
                         : fmt::format("did you mean '{}'?", nearest));
}

} // namespace

const std::vector<std::string>& backendNames()
{
    static const std::vector<std::string> names{"auto",       "egl",         "egl-surfaceless",
                                                "egl-device", "egl-default", "osmesa"};
    return names;
}

std::string loadFunctions(GLADloadfunc loader, ContextInfo& info)
{
    const int version = gladLoadGL(loader);
    if (version == 0)
        return "its OpenGL functions cannot be loaded";
    info.renderer = glText(GL_RENDERER);
    info.version = glText(GL_VERSION);
    if (version < GLAD_MAKE_VERSION(3, 3))
        return fmt::format("{} has only OpenGL {}", info.renderer, info.version);
    const std::array softwareRenderers{"llvmpipe", "softpipe", "swrast", "SWR", "Software Rasterizer"};
    info.software =
        std::any_of(softwareRenderers.begin(), softwareRenderers.end(),
                    [&info](const char* name) { return info.renderer.find(name) != std::string::npos; });
    return "";
}

std::unique_ptr<Context> makeContext(const std::string& backend, std::vector<BackendAttempt>* attempts)
{
    const auto& names = backendNames();
    if (std::find(names.begin(), names.end(), backend) == names.end())
        failUnknown(backend);
    std::vector<std::string> faults;
    for (const Backend& candidate : backends) {
        if (!answersTo(candidate, backend))
            continue;
        ContextTry attempt = candidate.attempt();
        if (attempts != nullptr)
            attempts->push_back({candidate.name, attempt.fault});
        if (attempt.context != nullptr)
            return std::move(attempt.context);
        faults.push_back(fmt::format("{}: {}", candidate.name, attempt.fault));
    }
    fail(ExitCode::noOpenGl, fmt::format("no OpenGL 3.3 context ({})", join(faults, "; ")),
         "install the packages libegl1 and libgl1-mesa-dri, or libosmesa6");
}

} // namespace dioptre
