// What the tests of the watcher share: a folder to save in, and a wait for what is told.
#pragma once

#include "base/file_watcher.h"

#include <gtest/gtest.h>

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <string>
#include <unistd.h>
#include <vector>

namespace dioptre
{

// A file that is open for writing, as by an editor that is under way.
class UnderWay
{
public:
    explicit UnderWay(const std::filesystem::path& file, const std::string& text = "half")
        : descriptor_(::open(file.c_str(), O_CREAT | O_TRUNC | O_WRONLY | O_CLOEXEC, 0644))
    {
        put(text);
    }
    UnderWay(const UnderWay&) = delete;
    UnderWay& operator=(const UnderWay&) = delete;
    ~UnderWay()
    {
        end();
    }
    void put(const std::string& text) const
    {
        if (::write(descriptor_, text.data(), text.size()) != static_cast<ssize_t>(text.size()))
            throw std::runtime_error("a file cannot be written");
    }
    void end()
    {
        if (descriptor_ >= 0)
            ::close(descriptor_);
        descriptor_ = -1;
    }

private:
    int descriptor_;
};

// The file `mark` is saved last of all: what comes before it has been told by then.
class FileWatching : public testing::Test
{
protected:
    using Names = std::vector<std::string>;

    FileWatching()
    {
        std::string pattern = testing::TempDir() + "dioptre-watch-XXXXXX"; // mkdtemp replaces them
        if (::mkdtemp(pattern.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        folder_ = std::filesystem::canonical(pattern);
        save("mark");
    }
    ~FileWatching() override
    {
        std::filesystem::remove_all(folder_);
    }

    std::filesystem::path at(const std::string& name) const
    {
        return folder_ / name;
    }
    void save(const std::string& name, const std::string& text = "text") const
    {
        std::ofstream(at(name), std::ios::binary) << text;
    }
    void saveByRename(const std::string& name, const std::string& text = "text") const
    {
        save(name + "~", text);
        move(name + "~", name);
    }
    void move(const std::string& from, const std::string& to) const
    {
        std::filesystem::rename(at(from), at(to));
    }
    void remove(const std::string& name) const
    {
        std::filesystem::remove_all(at(name));
    }
    void makeFolder(const std::string& name) const
    {
        std::filesystem::create_directories(at(name));
    }
    void link(const std::string& target, const std::string& name) const
    {
        std::filesystem::create_symlink(target, at(name));
    }
    void watch(const Names& names)
    {
        std::vector<std::filesystem::path> files;
        for (const std::string& name : names)
            files.push_back(at(name));
        watcher_.watch(files);
    }

    // All that is told until `last` is, each once, sorted.
    Names toldUntil(const std::string& last)
    {
        std::set<std::string> told;
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        std::unique_lock lock(mutex_);
        do {
            for (const auto& file : watcher_.changed())
                told.insert(file.lexically_relative(folder_).string());
            if (told.contains(last))
                return {told.begin(), told.end()};
        } while (woken_.wait_until(lock, limit, [&] { return std::exchange(isWoken_, false); }));
        ADD_FAILURE() << last << " was not told";
        return {told.begin(), told.end()};
    }
    // What is told of all that was done until now, but for removals.
    Names told()
    {
        save("mark");
        return withoutMark(toldUntil("mark"));
    }
    // As above, of removals too: they are told later.
    Names toldAtLength()
    {
        remove("mark");
        const Names names = withoutMark(toldUntil("mark"));
        save("mark");
        toldUntil("mark");
        return names;
    }

    std::filesystem::path folder_;
    std::mutex mutex_;
    std::condition_variable woken_;
    bool isWoken_ = false;
    FileWatcher watcher_{[this] {
        const std::scoped_lock lock(mutex_);
        isWoken_ = true;
        woken_.notify_all();
    }};

private:
    static Names withoutMark(Names names)
    {
        std::erase(names, "mark");
        return names;
    }
};

} // namespace dioptre
