// The kernel's tidings about files and folders.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// As inotify(7) describes it.
struct InotifyEvent {
    int watch = -1;         // -1 where events were lost
    std::uint32_t mask = 0; // IN_ bits
    std::string name;       // in the watched folder; empty where it is about the watched itself
};

class Inotify
{
public:
    // Throws retry where the user has too many of them.
    Inotify();
    Inotify(const Inotify&) = delete;
    Inotify& operator=(const Inotify&) = delete;
    ~Inotify();

    int descriptor() const; // readable when read() has something to give

    // Gives the watch's number, the same for the same file or folder, whose mask is replaced; nothing where
    // it is gone or must not be read. Throws retry where the user has too many.
    std::optional<int> watch(const std::filesystem::path& path, std::uint32_t mask);
    void drop(int watch);

    // What has come, a thousand events or more at a time; does not wait.
    std::vector<InotifyEvent> read();

private:
    int descriptor_;
};

} // namespace dioptre
