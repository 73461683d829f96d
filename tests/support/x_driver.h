// A user's hands and eyes on an X display: keys, pointer, clipboard, and the pixels that are seen.
#pragma once

#include "base/picture.h"

#include <functional>
#include <string>
#include <utility>
#include <vector>

struct _XDisplay;

namespace dioptre::test
{

struct Rgb {
    int red = 0, green = 0, blue = 0; // 0 to 255
    bool operator==(const Rgb&) const = default;
};

// Of an 8-bit picture, from its lower left.
Rgb pixelOf(const Picture& picture, int x, int y);

// Looks again and again until it is so; false after `limit_s`, generous since machines may be busy.
bool eventually(const std::function<bool()>& isSo, double limit_s = 30.0);

// Drives one window of one display. There need be no window manager: the focus is set by hand. Keys are
// keysyms' names as in X11/keysymdef.h, without XK_. Places are pixels from the window's upper left, as X has
// them; pictures have their rows from the bottom up. The server must outlive it: without one, Xlib ends the
// process.
class XDriver
{
public:
    // Waits for a window whose title begins so. Throws where there is none within `limit_s`, and as soon as
    // `isHopeless` says so.
    XDriver(const std::string& display, const std::string& title, const std::function<bool()>& isHopeless,
            double limit_s = 30.0);
    XDriver(const XDriver&) = delete;
    XDriver& operator=(const XDriver&) = delete;
    ~XDriver();

    void press(const std::string& key);
    void release(const std::string& key);
    void tap(const std::string& key, const std::vector<std::string>& modifiers = {});

    void moveTo(int x, int y);
    void pressButton(int button = 1); // X's: 1 left, 2 middle, 3 right
    void releaseButton(int button = 1);
    void drag(std::pair<int, int> from, std::pair<int, int> to, int button = 1, int steps = 8);
    void wheel(int notches); // above 0: away from the user

    Picture see() const; // srgb8, what the window shows now
    std::pair<int, int> size() const;
    std::string title() const;
    void resize(int width, int height);
    void askToClose(); // as a window manager's button does

    // What CLIPBOARD holds, by whoever owns it. Throws where nobody answers.
    std::string clipboard();

    // For what goes beyond keys and pointer: drop.h.
    _XDisplay* connection() const
    {
        return display_;
    }
    unsigned long window() const
    {
        return window_;
    }

private:
    void send(const std::string& key, bool down);

    _XDisplay* display_;
    unsigned long window_ = 0;
};

} // namespace dioptre::test
