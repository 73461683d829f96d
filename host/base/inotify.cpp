#include "base/inotify.h"

#include "base/error.h"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <sys/inotify.h>
#include <system_error>
#include <unistd.h>

namespace dioptre
{
namespace
{

[[noreturn]] void failFor(int fault, const std::filesystem::path& path)
{
    if (fault == ENOSPC)
        fail(ExitCode::retry, {.path = path.string()}, "cannot be watched for changes: no watches are left",
             "end a program that watches many files, or allow more as root: sysctl "
             "fs.inotify.max_user_watches=1048576");
    fail(ExitCode::retry, {.path = path.string()},
         fmt::format("cannot be watched for changes: {}", std::generic_category().message(fault)),
         "look whether its file system still answers");
}

} // namespace

Inotify::Inotify() : descriptor_(::inotify_init1(IN_NONBLOCK | IN_CLOEXEC))
{
    if (descriptor_ < 0)
        fail(ExitCode::retry,
             fmt::format("files cannot be watched for changes: {}", std::generic_category().message(errno)),
             "end a program that watches files, or allow more as root: sysctl "
             "fs.inotify.max_user_instances=1024 (and look at ulimit -n)");
}

Inotify::~Inotify()
{
    ::close(descriptor_);
}

int Inotify::descriptor() const
{
    return descriptor_;
}

std::optional<int> Inotify::watch(const std::filesystem::path& path, std::uint32_t mask)
{
    const int watch = ::inotify_add_watch(descriptor_, path.c_str(), mask);
    if (watch >= 0)
        return watch;
    if (errno != ENOENT && errno != ENOTDIR && errno != EACCES && errno != ELOOP && errno != ENAMETOOLONG)
        failFor(errno, path);
    return std::nullopt;
}

void Inotify::drop(int watch)
{
    ::inotify_rm_watch(descriptor_, watch);
}

std::vector<InotifyEvent> Inotify::read()
{
    std::vector<InotifyEvent> events;
    alignas(inotify_event) std::array<char, 65536> buffer;
    const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
    for (std::size_t at = 0; got > 0 && at < static_cast<std::size_t>(got);) {
        inotify_event head{};
        std::memcpy(&head, buffer.data() + at, sizeof head);
        const char* name = buffer.data() + at + sizeof head;
        events.push_back({head.wd, head.mask, std::string(name, ::strnlen(name, head.len))});
        at += sizeof head + head.len;
    }
    return events;
}

} // namespace dioptre
