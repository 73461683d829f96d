#include "support/x_driver.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>
#include <X11/Xutil.h>
#include <X11/extensions/XTest.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>

namespace dioptre::test
{
namespace
{

using Clock = std::chrono::steady_clock;

struct XRelease {
    void operator()(void* data) const
    {
        XFree(data);
    }
    void operator()(XImage* image) const
    {
        XDestroyImage(image);
    }
};

std::string titleOf(Display* display, Window window)
{
    char* title = nullptr;
    if (XFetchName(display, window, &title) == 0 || title == nullptr)
        return "";
    const std::unique_ptr<char, XRelease> kept(title);
    return title;
}

bool isShown(Display* display, Window window)
{
    XWindowAttributes attributes{};
    return XGetWindowAttributes(display, window, &attributes) != 0 && attributes.map_state == IsViewable;
}

// 0 where there is none.
Window findWindow(Display* display, const std::string& title)
{
    Window root = 0, parent = 0, *children = nullptr;
    unsigned count = 0;
    if (XQueryTree(display, DefaultRootWindow(display), &root, &parent, &children, &count) == 0 ||
        children == nullptr)
        return 0;
    const std::unique_ptr<Window, XRelease> kept(children);
    for (unsigned i = 0; i < count; ++i)
        if (titleOf(display, children[i]).starts_with(title) && isShown(display, children[i]))
            return children[i];
    return 0;
}

void pause_s(double time_s)
{
    std::this_thread::sleep_for(std::chrono::duration<double>(time_s));
}

} // namespace

Rgb pixelOf(const Picture& picture, int x, int y)
{
    const auto at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                         static_cast<std::size_t>(x));
    return {picture.bytes.at(at), picture.bytes.at(at + 1), picture.bytes.at(at + 2)};
}

bool eventually(const std::function<bool()>& isSo, double limit_s)
{
    const auto end = Clock::now() + std::chrono::duration<double>(limit_s);
    while (!isSo()) {
        if (Clock::now() > end)
            return false;
        pause_s(0.01);
    }
    return true;
}

XDriver::XDriver(const std::string& display, const std::string& title,
                 const std::function<bool()>& isHopeless, double limit_s)
    : display_(XOpenDisplay(display.c_str()))
{
    if (display_ == nullptr)
        throw std::runtime_error("no X server answers as " + display);
    // A window may end while it is asked after, which Xlib would end this process for.
    XSetErrorHandler([](Display*, XErrorEvent*) { return 0; });
    eventually([&] { return (window_ = findWindow(display_, title)) != 0 || isHopeless(); }, limit_s);
    if (window_ == 0) {
        XCloseDisplay(display_);
        throw std::runtime_error("no window whose title begins with '" + title + "' appears");
    }
    XSetInputFocus(display_, window_, RevertToParent, CurrentTime);
    XSync(display_, False);
}

XDriver::~XDriver()
{
    XCloseDisplay(display_);
}

void XDriver::send(const std::string& key, bool down)
{
    const KeySym symbol = XStringToKeysym(key.c_str());
    const KeyCode code = symbol == NoSymbol ? KeyCode(0) : XKeysymToKeycode(display_, symbol);
    if (code == 0)
        throw std::runtime_error("this keyboard has no key " + key);
    XTestFakeKeyEvent(display_, code, down ? True : False, CurrentTime);
    XSync(display_, False);
}

void XDriver::press(const std::string& key)
{
    send(key, true);
}

void XDriver::release(const std::string& key)
{
    send(key, false);
}

void XDriver::tap(const std::string& key, const std::vector<std::string>& modifiers)
{
    for (const auto& modifier : modifiers)
        press(modifier);
    press(key);
    release(key);
    pause_s(0.025); // of two in a millisecond GLFW drops one, and of two in 20 it takes one for a repeat
    for (const auto& modifier : modifiers)
        release(modifier);
}

void XDriver::moveTo(int x, int y)
{
    int rootX = 0, rootY = 0;
    Window child = 0;
    XTranslateCoordinates(display_, window_, DefaultRootWindow(display_), x, y, &rootX, &rootY, &child);
    XTestFakeMotionEvent(display_, -1, rootX, rootY, CurrentTime);
    XSync(display_, False);
}

void XDriver::pressButton(int button)
{
    XTestFakeButtonEvent(display_, static_cast<unsigned>(button), True, CurrentTime);
    XSync(display_, False);
}

void XDriver::releaseButton(int button)
{
    XTestFakeButtonEvent(display_, static_cast<unsigned>(button), False, CurrentTime);
    XSync(display_, False);
}

void XDriver::drag(std::pair<int, int> from, std::pair<int, int> to, int button, int steps)
{
    moveTo(from.first, from.second);
    pressButton(button);
    for (int i = 1; i <= steps; ++i) {
        moveTo(from.first + (to.first - from.first) * i / steps,
               from.second + (to.second - from.second) * i / steps);
        pause_s(0.005);
    }
    releaseButton(button);
}

void XDriver::wheel(int notches)
{
    for (int i = 0; i < std::abs(notches); ++i) {
        pressButton(notches > 0 ? 4 : 5);
        releaseButton(notches > 0 ? 4 : 5);
    }
}

Picture XDriver::see() const
{
    const auto [width, height] = size();
    Picture picture{width, height, PixelFormat::srgb8, {}, {}};
    const std::unique_ptr<XImage, XRelease> image(
        XGetImage(display_, window_, 0, 0, static_cast<unsigned>(width), static_cast<unsigned>(height),
                  AllPlanes, ZPixmap));
    if (image == nullptr)
        throw std::runtime_error("the window's pixels cannot be read");
    picture.bytes.reserve(4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x) {
            const unsigned long pixel = XGetPixel(image.get(), x, y); // 0xRRGGBB in a visual of depth 24
            for (const int shift : {16, 8, 0})
                picture.bytes.push_back(static_cast<std::uint8_t>((pixel >> shift) & 255U));
            picture.bytes.push_back(255);
        }
    return picture;
}

std::pair<int, int> XDriver::size() const
{
    XWindowAttributes attributes{};
    if (XGetWindowAttributes(display_, window_, &attributes) == 0)
        throw std::runtime_error("the window is gone");
    return {attributes.width, attributes.height};
}

std::string XDriver::title() const
{
    return titleOf(display_, window_);
}

void XDriver::resize(int width, int height)
{
    XResizeWindow(display_, window_, static_cast<unsigned>(width), static_cast<unsigned>(height));
    XSync(display_, False);
}

void XDriver::askToClose()
{
    XEvent event{};
    event.xclient.type = ClientMessage;
    event.xclient.window = window_;
    event.xclient.message_type = XInternAtom(display_, "WM_PROTOCOLS", False);
    event.xclient.format = 32;
    event.xclient.data.l[0] = static_cast<long>(XInternAtom(display_, "WM_DELETE_WINDOW", False));
    XSendEvent(display_, window_, False, NoEventMask, &event);
    XSync(display_, False);
}

std::string XDriver::clipboard()
{
    const Window own = XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0);
    const Atom property = XInternAtom(display_, "DIOPTRE_TEST", False);
    const Atom text = XInternAtom(display_, "UTF8_STRING", False);
    XConvertSelection(display_, XInternAtom(display_, "CLIPBOARD", False), text, property, own, CurrentTime);
    XEvent event{};
    const bool answered = eventually(
        [&] { return XCheckTypedWindowEvent(display_, own, SelectionNotify, &event) == True; }, 10.0);
    std::string found;
    if (answered && event.xselection.property != 0) {
        Atom type = 0;
        int format = 0;
        unsigned long items = 0, left = 0;
        unsigned char* data = nullptr;
        XGetWindowProperty(display_, own, property, 0, 1 << 20, True, AnyPropertyType, &type, &format, &items,
                           &left, &data);
        const std::unique_ptr<unsigned char, XRelease> kept(data);
        found.assign(reinterpret_cast<const char*>(data), items);
    }
    XDestroyWindow(display_, own);
    if (!answered)
        throw std::runtime_error("nobody answers for the clipboard");
    return found;
}

} // namespace dioptre::test
