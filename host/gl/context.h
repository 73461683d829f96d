// An OpenGL 3.3 core context, without a window unless one is asked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace dioptre
{

// What a context says of itself.
struct ContextInfo {
    std::string backend;  // "egl-surfaceless", "egl-device", "egl-default", "osmesa" or "window"
    std::string renderer; // GL_RENDERER
    std::string version;  // GL_VERSION
    bool software =
        false; // llvmpipe, softpipe or swrast: timer queries lie there, a monotonic clock is used instead
    std::string glslVersion = ""; // GL_SHADING_LANGUAGE_VERSION
};

// Owns a context that is current on the thread that made it; GL functions are loaded for it.
class Context
{
public:
    virtual ~Context() = default;
    const ContextInfo& info() const
    {
        return info_;
    }

protected:
    ContextInfo info_;
};

// The mend where no backend works.
inline constexpr const char* packagesForOpenGl =
    "install the packages libegl1 and libgl1-mesa-dri, or libosmesa6";

// One attempt and what came of it, for logs and error messages.
struct BackendAttempt {
    std::string backend;
    std::string outcome; // "" when it worked
    std::string mend = packagesForOpenGl;
    bool absent = false; // nothing is broken: the machine, as it is set up, does not have it
};

// A word that --backend takes.
struct BackendChoice {
    std::string name;
    std::string meaning; // a phrase for people
    std::vector<std::string>
        tries; // the single backends that it stands for, in the order in which they are tried
};

// "auto", "egl", "egl-surfaceless", "egl-device", "egl-default", "osmesa", "window".
const std::vector<BackendChoice>& backendChoices();
std::vector<std::string> backendNames();

// Throws usage for a name that is none of them.
const BackendChoice& backendChoice(const std::string& name);

// Makes a context by the first backend that works of those that the name stands for; of several, by the first
// that draws on a graphics card where EGL lists one: Mesa's surfaceless display draws in software beside
// another maker's card. Each try is added to `attempts` if given. Throws noOpenGl, naming every attempt, when
// none works.
std::unique_ptr<Context> makeContext(const std::string& backend,
                                     std::vector<BackendAttempt>* attempts = nullptr);

} // namespace dioptre
