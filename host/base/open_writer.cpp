#include "base/open_writer.h"

#include <cerrno>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace dioptre
{

// The kernel grants a lease for reading only while no one writes; see fcntl(2), F_SETLEASE.
bool hasWriter(const std::filesystem::path& file)
{
    struct stat status {
    };
    if (::stat(file.c_str(), &status) != 0 || !S_ISREG(status.st_mode))
        return false; // to open a pipe or a device may do something
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    if (descriptor < 0)
        return false;
    // Who opens the file meanwhile waits until the lease is given back, and we get a signal: one that by
    // default does nothing, in place of SIGIO, which ends the process.
    ::fcntl(descriptor, F_SETSIG, SIGURG);
    const bool granted = ::fcntl(descriptor, F_SETLEASE, F_RDLCK) == 0;
    const bool refused = !granted && errno == EAGAIN;
    if (granted)
        ::fcntl(descriptor, F_SETLEASE, F_UNLCK);
    ::close(descriptor);
    return refused;
}

} // namespace dioptre
