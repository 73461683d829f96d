#include "support/x_drop.h"

#include <X11/Xatom.h>
#include <X11/Xlib.h>

#include <array>
#include <stdexcept>

namespace dioptre::test
{
namespace
{

class DropSource
{
public:
    DropSource(XDriver& driver, std::string list)
        : display_(driver.connection()), target_(driver.window()),
          own_(XCreateSimpleWindow(display_, DefaultRootWindow(display_), 0, 0, 1, 1, 0, 0, 0)),
          list_(std::move(list))
    {
        XSetSelectionOwner(display_, atom("XdndSelection"), own_, CurrentTime);
    }
    DropSource(const DropSource&) = delete;
    DropSource& operator=(const DropSource&) = delete;
    ~DropSource()
    {
        XDestroyWindow(display_, own_);
        XSync(display_, False);
    }

    Atom atom(const char* name) const
    {
        return XInternAtom(display_, name, False);
    }

    // `more`: data.l[1] to [4].
    void tell(const char* message, const std::array<long, 4>& more) const
    {
        XEvent event{};
        event.xclient.type = ClientMessage;
        event.xclient.window = target_;
        event.xclient.message_type = atom(message);
        event.xclient.format = 32;
        event.xclient.data.l[0] = static_cast<long>(own_);
        for (std::size_t i = 0; i < more.size(); ++i)
            event.xclient.data.l[i + 1] = more[i];
        XSendEvent(display_, target_, False, NoEventMask, &event);
        XFlush(display_);
    }

    // Waits for the target's message, while it is given what it asks for. Its data.l[1].
    long hear(const char* message) const
    {
        XEvent event{};
        const bool heard = eventually(
            [&] {
                while (XCheckTypedWindowEvent(display_, own_, SelectionRequest, &event) == True)
                    give(event.xselectionrequest);
                return XCheckTypedWindowEvent(display_, own_, ClientMessage, &event) == True &&
                       event.xclient.message_type == atom(message);
            },
            10.0);
        if (!heard)
            throw std::runtime_error(std::string("the window gives no ") + message);
        return event.xclient.data.l[1];
    }

private:
    void give(const XSelectionRequestEvent& request) const
    {
        XChangeProperty(display_, request.requestor, request.property, request.target, 8, PropModeReplace,
                        reinterpret_cast<const unsigned char*>(list_.data()), static_cast<int>(list_.size()));
        XEvent answer{};
        answer.xselection.type = SelectionNotify;
        answer.xselection.requestor = request.requestor;
        answer.xselection.selection = request.selection;
        answer.xselection.target = request.target;
        answer.xselection.property = request.property;
        answer.xselection.time = request.time;
        XSendEvent(display_, request.requestor, False, NoEventMask, &answer);
        XFlush(display_);
    }

    Display* display_;
    Window target_;
    Window own_;
    std::string list_;
};

} // namespace

void drop(XDriver& driver, const std::vector<std::filesystem::path>& files)
{
    std::string list;
    for (const auto& file : files)
        list += "file://" + std::filesystem::absolute(file).string() + "\r\n";
    const DropSource source(driver, list);
    constexpr long version = 5;
    source.tell("XdndEnter", {version << 24, static_cast<long>(source.atom("text/uri-list")), 0, 0});
    source.tell("XdndPosition",
                {0, (10L << 16) | 10L, CurrentTime, static_cast<long>(source.atom("XdndActionCopy"))});
    if ((source.hear("XdndStatus") & 1) == 0)
        throw std::runtime_error("the window takes no files");
    source.tell("XdndDrop", {0, CurrentTime, 0, 0});
    source.hear("XdndFinished");
}

} // namespace dioptre::test
