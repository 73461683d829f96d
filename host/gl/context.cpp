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
    const char* meaning; // a phrase for people
    ContextTry (*attempt)();
    bool inAuto = true;
};

// In the order in which "auto" tries them.
constexpr std::array<Backend, 5> backends{
    {{"egl-surfaceless", "Mesa's EGL without display or window", tryEglSurfaceless},
     {"egl-device", "EGL's first device that works, a graphics card where there is one", tryEglDevice},
     {"egl-default", "EGL's default display, such as the desktop's", tryEglDefault},
     {"osmesa", "Mesa in memory without EGL, loaded where it is installed", tryOsMesa},
     {"window", "an invisible window under X, by GLFW where it is installed; by name alone", tryWindow,
      false}}};

ContextTry attempt(const std::string& name)
{
    const auto* const backend = std::find_if(backends.begin(), backends.end(),
                                             [&name](const Backend& each) { return each.name == name; });
    return backend->attempt();
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

const std::vector<BackendChoice>& backendChoices()
{
    static const std::vector<BackendChoice> choices = [] {
        std::vector<BackendChoice> all{{"auto", "all in turn that need no window", {}},
                                       {"egl", "the three of EGL in turn", {}}};
        for (const Backend& backend : backends) {
            const std::string name = backend.name;
            all.push_back({name, backend.meaning, {name}});
            if (backend.inAuto)
                all[0].tries.push_back(name);
            if (name.starts_with("egl-"))
                all[1].tries.push_back(name);
        }
        return all;
    }();
    return choices;
}

std::vector<std::string> backendNames()
{
    std::vector<std::string> names;
    for (const BackendChoice& choice : backendChoices())
        names.push_back(choice.name);
    return names;
}

const BackendChoice& backendChoice(const std::string& name)
{
    const auto& choices = backendChoices();
    const auto found = std::find_if(choices.begin(), choices.end(),
                                    [&name](const BackendChoice& choice) { return choice.name == name; });
    if (found == choices.end())
        failUnknown(name);
    return *found;
}

std::string loadFunctions(GLADloadfunc loader, ContextInfo& info)
{
    const int version = gladLoadGL(loader);
    if (version == 0)
        return "its OpenGL functions cannot be loaded";
    info.renderer = glText(GL_RENDERER);
    info.version = glText(GL_VERSION);
    info.glslVersion = glText(GL_SHADING_LANGUAGE_VERSION);
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
    std::vector<std::string> faults;
    std::string mend;
    std::string software; // the first that works, yet draws in software beside a graphics card
    const auto& tries = backendChoice(backend).tries;
    for (const std::string& name : tries) {
        ContextTry result = attempt(name);
        if (attempts != nullptr)
            attempts->push_back({name, result.fault, result.mend, result.absent});
        mend = result.mend; // of several they are alike
        if (result.context == nullptr)
            faults.push_back(fmt::format("{}: {}", name, result.fault));
        else if (tries.size() == 1 || !result.context->info().software || !eglListsGraphicsCard())
            return std::move(result.context);
        else if (software.empty())
            software = name;
    }
    if (!software.empty())
        if (ContextTry again = attempt(software); again.context != nullptr)
            return std::move(again.context);
    fail(ExitCode::noOpenGl, fmt::format("no OpenGL 3.3 context ({})", join(faults, "; ")), mend);
}

} // namespace dioptre
