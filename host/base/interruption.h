// Ctrl-C and the like as a wish that long work looks at, so that it leaves whole files only.
#pragma once

#include <functional>

namespace dioptre
{

// While it lives, the first SIGINT, SIGTERM or SIGHUP is noted; a second ends the process at once. Those that
// were ignored stay so. One at a time.
class Interruption
{
public:
    Interruption();
    Interruption(const Interruption&) = delete;
    Interruption& operator=(const Interruption&) = delete;
    ~Interruption();

    // That was noted; 0 for none.
    static int signal();

    // Throws retry where one was noted.
    static void check();
};

// Works until the end or until a signal is noted and comes to be heard. Gives the signal, 0 for none.
int signalDuring(const std::function<void()>& work);

// Ends the process as the signal would have, so that its parent sees why. Only for what handles it as usual.
[[noreturn]] void endBySignal(int signal);

} // namespace dioptre
