#include "file_watcher_fixture.h"

#include <map>
#include <random>

namespace dioptre
{
namespace
{

// Five files: two beside each other, one in a folder that is moved about, one by a link to a file, one by a
// link to a folder.
class FileWatcherStress : public FileWatching
{
protected:
    FileWatcherStress()
    {
        makeFolder("in");
        makeFolder("far0");
        makeFolder("far1");
        for (const char* name : {"a", "b", "in/a", "far0/a", "far1/a", "target0", "target1"})
            save(name, "0");
        link("target0", "link");
        link("far0", "way");
        watch(names_);
    }

    void saveAnyhow(const std::string& name, const std::string& text)
    {
        switch (random_() % 7) {
        case 0:
            return save(name, text);
        case 1:
            save(name, "");
            return save(name, text);
        case 2:
            return saveByRename(name, text);
        case 3:
            remove(name);
            return save(name, text);
        case 4:
            move(name, name + ".old");
            return save(name, text);
        case 5: {
            const UnderWay writer(at(name), "");
            std::this_thread::yield();
            return writer.put(text);
        }
        default:
            return linkAnew(name, text);
        }
    }
    void linkAnew(const std::string& name, const std::string& text) const
    {
        save(name + "~", text);
        remove(name);
        std::filesystem::create_hard_link(at(name + "~"), at(name));
        remove(name + "~");
    }
    // Saves the target that is not shown, then turns the link to it.
    void turn(const std::string& link, const std::string& target, const std::string& file,
              const std::string& text)
    {
        std::error_code fault; // a save may have put a file in the link's place
        const bool isFirst = std::filesystem::read_symlink(at(link), fault) == target + "0";
        const std::string other = target + (isFirst ? "1" : "0");
        saveAnyhow(other + file, text);
        this->link(other, link + "~");
        move(link + "~", link);
    }
    void moveAbout(const std::string& folder, const std::string& text)
    {
        move(folder, folder + "-gone");
        saveAnyhow(folder + "-gone/a", text);
        move(folder + "-gone", folder);
    }

    static std::string textOf(const std::filesystem::path& file)
    {
        std::string text;
        std::ifstream stream(file);
        std::getline(stream, text);
        return text;
    }
    // Reads what is told, as a program that shows it would.
    void readTold(std::map<std::string, std::string>& texts)
    {
        for (const auto& file : watcher_.changed())
            texts[file.lexically_relative(folder_).string()] = textOf(file);
    }
    void readUntil(const std::map<std::string, std::string>& saved, std::map<std::string, std::string>& read)
    {
        const auto limit = std::chrono::steady_clock::now() + std::chrono::seconds(30);
        std::unique_lock lock(mutex_);
        for (readTold(read); read != saved; readTold(read))
            if (!woken_.wait_until(lock, limit, [&] { return std::exchange(isWoken_, false); }))
                return;
    }

    const Names names_{"a", "b", "in/a", "link", "way/a"};
    std::mt19937 random_{20};
};

} // namespace

TEST_F(FileWatcherStress, SavesOfAllKinds_LeaveAReaderOfWhatIsToldWithTheLastTexts)
{
    std::map<std::string, std::string> saved, read;
    for (int count = 1; count <= 400; ++count) {
        const std::string& name = names_[random_() % names_.size()];
        const std::string text = std::to_string(count);
        const bool isPlain = random_() % 2 == 0;
        if (name == "link" && !isPlain)
            turn("link", "target", "", text);
        else if (name == "way/a" && !isPlain)
            turn("way", "far", "/a", text);
        else if (name == "in/a" && !isPlain)
            moveAbout("in", text);
        else
            saveAnyhow(name, text);
        saved[name] = text;
        if (random_() % 8 == 0)
            std::this_thread::sleep_for(std::chrono::milliseconds(random_() % 6));
        if (random_() % 8 == 0)
            watch(names_);
        readTold(read);
    }
    readUntil(saved, read);
    EXPECT_EQ(read, saved);
}

} // namespace dioptre
