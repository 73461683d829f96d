#include "live/window.h"

#include "base/error.h"
#include "gl/backend.h"
#include "live/lost_display.h"

#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <cstdlib>
#include <utility>

namespace dioptre
{
namespace
{

[[noreturn]] void failWithoutDisplay()
{
    const char* words = nullptr;
    glfwGetError(&words);
    const char* const display = std::getenv("DISPLAY");
    const bool named = display != nullptr && *display != '\0';
    fail(ExitCode::noOpenGl,
         fmt::format("{} ({})", named ? "no window can be opened on this display" : "there is no display",
                     words != nullptr ? words : "GLFW gives no reason"),
         "run it where there is a screen, put 'xvfb-run -a' before the command, or draw a still without a "
         "window by 'dioptre render'");
}

Window& owner(GLFWwindow* window)
{
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

} // namespace

Window::Window(const glm::ivec2& size_px, const std::string& title)
{
    glfwInitHint(GLFW_JOYSTICK_HAT_BUTTONS, GLFW_FALSE);
    if (glfwInit() == GLFW_FALSE)
        failWithoutDisplay();
    endWithTheDisplay();
    for (const auto& [hint, value] : {std::pair{GLFW_CONTEXT_VERSION_MAJOR, 3},
                                      {GLFW_CONTEXT_VERSION_MINOR, 3},
                                      {GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE},
                                      {GLFW_SCALE_TO_MONITOR, GLFW_FALSE},
                                      {GLFW_DEPTH_BITS, 0},
                                      {GLFW_STENCIL_BITS, 0}})
        glfwWindowHint(hint, value);
    window_ = glfwCreateWindow(size_px.x, size_px.y, title.c_str(), nullptr, nullptr);
    if (window_ == nullptr) {
        const char* words = nullptr;
        glfwGetError(&words);
        const std::string why = words != nullptr ? words : "GLFW gives no reason";
        glfwTerminate();
        fail(ExitCode::noOpenGl, fmt::format("no window for OpenGL 3.3 core ({})", why),
             "install the packages libgl1 and libgl1-mesa-dri");
    }
    glfwMakeContextCurrent(window_);
    context_.backend = "window";
    if (const auto fault = loadFunctions(glfwGetProcAddress, context_); !fault.empty()) {
        glfwTerminate();
        fail(ExitCode::noOpenGl, fault, "install the packages libgl1 and libgl1-mesa-dri");
    }
    glfwSwapInterval(1);
    // On screens whose units are not pixels the window was made too large.
    if (const glm::ivec2 made = this->size_px(); made != size_px && made.x > 0 && made.y > 0)
        glfwSetWindowSize(window_, size_px.x * size_px.x / made.x, size_px.y * size_px.y / made.y);
    listen();
}

Window::~Window()
{
    glfwTerminate();
}

void Window::listen()
{
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int modifiers) {
        owner(window).events_.push_back({.kind = InputEvent::Kind::key,
                                         .key = key,
                                         .down = action != GLFW_RELEASE,
                                         .again = action == GLFW_REPEAT,
                                         .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                         .control = (modifiers & GLFW_MOD_CONTROL) != 0});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int modifiers) {
        owner(window).events_.push_back({.kind = InputEvent::Kind::button,
                                         .key = button,
                                         .down = action == GLFW_PRESS,
                                         .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                                         .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                                         .at_px = owner(window).pointer_px_});
    });
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        owner(window).pointer_px_ = owner(window).pixelAt(x, y);
        owner(window).events_.push_back({.kind = InputEvent::Kind::move, .at_px = owner(window).pointer_px_});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double, double notches) {
        owner(window).events_.push_back(
            {.kind = InputEvent::Kind::scroll, .at_px = owner(window).pointer_px_, .scroll = notches});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        owner(window).events_.push_back({.kind = InputEvent::Kind::drop, .files = {paths, paths + count}});
    });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* window, int, int) { owner(window).damaged_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { owner(window).damaged_ = true; });
}

glm::ivec2 Window::size_px() const
{
    glm::ivec2 size{0};
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

glm::ivec2 Window::sizeOnDesktop_px() const
{
    glm::ivec2 units{0};
    glfwGetWindowSize(window_, &units.x, &units.y);
    if (!isFullscreen() || units.x == 0 || units.y == 0)
        return size_px();
    return size_px() * glm::ivec2(beforeFullscreen_.width, beforeFullscreen_.height) / units;
}

// A pixel's centre is at a half, as gl_FragCoord has it; y counts from the lower left.
glm::dvec2 Window::pixelAt(double x, double y) const
{
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const glm::dvec2 pixels = size_px();
    if (width == 0 || height == 0)
        return glm::dvec2(0.0);
    return {(x + 0.5) * pixels.x / width, pixels.y - (y + 0.5) * pixels.y / height};
}

bool Window::isClosing() const
{
    return glfwWindowShouldClose(window_) != 0;
}

void Window::close()
{
    glfwSetWindowShouldClose(window_, GLFW_TRUE);
}

void Window::hide()
{
    glfwHideWindow(window_);
    glfwPollEvents();
}

void Window::setTitle(const std::string& title)
{
    glfwSetWindowTitle(window_, title.c_str());
}

void Window::setClipboard(const std::string& text)
{
    glfwSetClipboardString(window_, text.c_str());
}

bool Window::isFullscreen() const
{
    return glfwGetWindowMonitor(window_) != nullptr;
}

void Window::toggleFullscreen()
{
    if (isFullscreen()) {
        const Place& place = beforeFullscreen_;
        glfwSetWindowMonitor(window_, nullptr, place.x, place.y, place.width, place.height, GLFW_DONT_CARE);
    } else if (GLFWmonitor* monitor = glfwGetPrimaryMonitor(); monitor != nullptr) {
        glfwGetWindowPos(window_, &beforeFullscreen_.x, &beforeFullscreen_.y);
        glfwGetWindowSize(window_, &beforeFullscreen_.width, &beforeFullscreen_.height);
        const GLFWvidmode* mode = glfwGetVideoMode(monitor);
        glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
    }
    damaged_ = true;
}

void Window::swap()
{
    glfwSwapBuffers(window_);
}

void Window::wait(double timeout_s)
{
    if (timeout_s > 0.0)
        glfwWaitEventsTimeout(timeout_s);
    else
        glfwPollEvents();
}

void Window::wake()
{
    glfwPostEmptyEvent();
}

std::vector<InputEvent> Window::takeEvents()
{
    return std::exchange(events_, {});
}

bool Window::takeDamage()
{
    return std::exchange(damaged_, false);
}

bool Window::isHeld(int key) const
{
    return glfwGetWindowAttrib(window_, GLFW_FOCUSED) != 0 && glfwGetKey(window_, key) == GLFW_PRESS;
}

} // namespace dioptre
