// A window with an OpenGL 3.3 core context, and what its user does.
#pragma once

#include "gl/context.h"

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

struct GLFWwindow;

namespace dioptre
{

// Keys and buttons by GLFW's numbers.
struct InputEvent {
    enum class Kind { key, button, move, scroll, drop };
    Kind kind = Kind::key;
    int key = 0; // or button
    bool down = false;
    bool again = false; // the key is down still, and the keyboard repeats it
    bool shift = false;
    bool control = false;
    glm::dvec2 at_px{0.0};                      // of the pointer, from the picture's lower left
    double scroll = 0.0;                        // away from the user, notches
    std::vector<std::filesystem::path> files{}; // dropped
};

// One at a time. All of it belongs to the thread that made it, but wake().
class Window
{
public:
    // A picture of so many pixels, whatever the screen's scale. Throws noOpenGl where there is no display or
    // no OpenGL 3.3.
    Window(const glm::ivec2& size_px, const std::string& title);
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;
    ~Window();

    const ContextInfo& context() const
    {
        return context_;
    }
    GLFWwindow* handle() const
    {
        return window_;
    }

    glm::ivec2 size_px() const; // of the picture in it; 0 while it is minimised
    bool isClosing() const;
    void close();
    void hide();
    void setTitle(const std::string& title);
    void setClipboard(const std::string& text);
    void toggleFullscreen();
    bool isFullscreen() const;
    glm::ivec2 sizeOnDesktop_px() const; // of the picture, where it is or was not fullscreen

    // Shows what was drawn.
    void swap();

    // Returns when something happened, or after the time; 0 looks alone.
    void wait(double timeout_s);

    // Ends a wait, from any thread.
    static void wake();

    // What happened since the last call, in order.
    std::vector<InputEvent> takeEvents();

    // Whether the window's contents were lost or its size changed since the last call.
    bool takeDamage();

    // Whether the key is held. Not while the window is not in front.
    bool isHeld(int key) const;

private:
    struct Place {
        int x = 0, y = 0, width = 0, height = 0;
    };
    void listen();
    glm::dvec2 pixelAt(double x, double y) const;

    GLFWwindow* window_ = nullptr;
    ContextInfo context_;
    std::vector<InputEvent> events_;
    glm::dvec2 pointer_px_{0.0}; // by its last move: the server would tell where it is by now
    bool damaged_ = true;
    Place beforeFullscreen_;
};

} // namespace dioptre
