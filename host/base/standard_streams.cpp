#include "base/standard_streams.h"

#include <cstdio>
#include <fcntl.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

bool isClosed(int stream)
{
    return ::fcntl(stream, F_GETFD) < 0;
}

} // namespace

void holdStandardStreams()
{
    // Each open() takes the lowest number that is free.
    if (isClosed(STDIN_FILENO))
        ::open("/dev/null", O_RDONLY);
    if (isClosed(STDOUT_FILENO) && ::open("/dev/full", O_WRONLY) < 0)
        ::open("/dev/null", O_WRONLY);
    if (isClosed(STDERR_FILENO))
        ::open("/dev/null", O_WRONLY);
}

bool standardOutputTaken()
{
    const bool flushed = std::fflush(stdout) == 0;
    return flushed && std::ferror(stdout) == 0;
}

} // namespace dioptre
