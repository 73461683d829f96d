#include "gl/backend.h"

#include <fmt/format.h>

#include <cstdlib>
#include <dlfcn.h>
#include <initializer_list>
#include <utility>

namespace dioptre
{
namespace
{

// What of GLFW/glfw3.h is used here. The library is loaded at run time: linked it brings libX11 into every
// start, and a machine without X would have to have both for a picture that needs neither.
struct Glfw {
    using Window = struct GLFWwindow*;
    static constexpr int visible = 0x20004, contextMajor = 0x22002, contextMinor = 0x22003, profile = 0x22008,
                         coreProfile = 0x32001;

    int (*init)() = nullptr;
    void (*terminate)() = nullptr;
    int (*getError)(const char** description) = nullptr;
    void (*windowHint)(int hint, int value) = nullptr;
    Window (*createWindow)(int width, int height, const char* title, struct GLFWmonitor*,
                           Window share) = nullptr;
    void (*makeContextCurrent)(Window) = nullptr;
    GLADloadfunc getProcAddress = nullptr;

    bool complete() const
    {
        return init && terminate && getError && windowHint && createWindow && makeContextCurrent &&
               getProcAddress;
    }
};

template <typename Function>
void findFunction(Function& function, void* library, const char* name)
{
    function = reinterpret_cast<Function>(dlsym(library, name));
}

// Stays loaded for the life of the process, as OSMesa does.
Glfw loadGlfw()
{
    Glfw glfw;
    void* const library = dlopen("libglfw.so.3", RTLD_NOW | RTLD_LOCAL);
    if (library == nullptr)
        return glfw;
    findFunction(glfw.init, library, "glfwInit");
    findFunction(glfw.terminate, library, "glfwTerminate");
    findFunction(glfw.getError, library, "glfwGetError");
    findFunction(glfw.windowHint, library, "glfwWindowHint");
    findFunction(glfw.createWindow, library, "glfwCreateWindow");
    findFunction(glfw.makeContextCurrent, library, "glfwMakeContextCurrent");
    findFunction(glfw.getProcAddress, library, "glfwGetProcAddress");
    return glfw;
}

bool isDisplayNamed()
{
    const char* const display = std::getenv("DISPLAY");
    return display != nullptr && *display != '\0';
}

// What went wrong, as in a ContextTry.
struct WindowFault {
    std::string what;
    const char* mend = "";
    bool absent = false;
};

// An invisible window: its context is wanted, all drawing goes into textures, whose pixels no screen scales.
// Ending GLFW ends every other window: one at a time.
class WindowContext final : public Context
{
public:
    explicit WindowContext(const Glfw& glfw) : glfw_(glfw)
    {
        info_.backend = "window";
    }
    WindowContext(const WindowContext&) = delete;
    WindowContext& operator=(const WindowContext&) = delete;

    ~WindowContext() override
    {
        glfw_.terminate(); // closes the window, and does nothing where GLFW did not start
    }

    // Makes the context, makes it current and loads its functions.
    WindowFault start()
    {
        if (!glfw_.init())
            return {inWords(isDisplayNamed() ? "GLFW does not start" : "there is no display"), mendOfDisplay,
                    !isDisplayNamed()};
        for (const auto& [hint, value] :
             std::initializer_list<std::pair<int, int>>{{Glfw::visible, 0},
                                                        {Glfw::contextMajor, 3},
                                                        {Glfw::contextMinor, 3},
                                                        {Glfw::profile, Glfw::coreProfile}})
            glfw_.windowHint(hint, value);
        const Glfw::Window window = glfw_.createWindow(1, 1, "dioptre", nullptr, nullptr);
        if (window == nullptr)
            return {inWords("no window for OpenGL 3.3 core"), mendOfDriver};
        glfw_.makeContextCurrent(window);
        return {loadFunctions(glfw_.getProcAddress, info_), mendOfDriver};
    }

private:
    static constexpr const char* mendOfDisplay =
        "set DISPLAY to an X server, put 'xvfb-run -a' before the command, or take another --backend";
    static constexpr const char* mendOfDriver =
        "install the packages libgl1 and libgl1-mesa-dri, or take another --backend";

    // With GLFW's own words for its last error.
    std::string inWords(const char* what) const
    {
        const char* words = nullptr;
        glfw_.getError(&words);
        return words != nullptr ? fmt::format("{} ({})", what, words) : what;
    }

    Glfw glfw_;
};

} // namespace

ContextTry tryWindow()
{
    const Glfw glfw = loadGlfw();
    if (!glfw.complete())
        return {nullptr, "GLFW 3.3 is not installed",
                "install the package libglfw3, or take another --backend", true};
    auto context = std::make_unique<WindowContext>(glfw);
    const WindowFault fault = context->start();
    if (!fault.what.empty())
        return {nullptr, fault.what, fault.mend, fault.absent};
    return {std::move(context), ""};
}

} // namespace dioptre
