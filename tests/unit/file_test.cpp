#include "base/error.h"
#include "base/file.h"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// A folder of its own for each test, removed afterwards.
class File : public testing::Test
{
protected:
    File() : folder_(fs::path(testing::TempDir()) / ("dioptre-file-" + std::to_string(::getpid())))
    {
        fs::create_directories(folder_);
    }
    ~File() override
    {
        fs::remove_all(folder_);
    }

    static void write(const fs::path& path, const std::string& text)
    {
        std::ofstream(path, std::ios::binary) << text;
    }

    std::size_t filesInFolder() const
    {
        return static_cast<std::size_t>(
            std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
    }

    fs::path folder_;
};

ExitCode codeOf(const std::function<void()>& action)
{
    try {
        action();
    } catch (const Error& error) {
        return error.code();
    }
    return ExitCode::done;
}

TEST_F(File, ReadFile_GivesEveryByte)
{
    const std::string bytes("a\0b\r\n\xff", 6);
    write(folder_ / "in", bytes);
    EXPECT_EQ(readFile(folder_ / "in"), bytes);
    write(folder_ / "empty", "");
    EXPECT_EQ(readFile(folder_ / "empty"), "");
}

TEST_F(File, ReadFile_MissingOrFolder_IsInputMissing)
{
    EXPECT_EQ(codeOf([&] { readFile(folder_ / "absent"); }), ExitCode::inputMissing);
    EXPECT_EQ(codeOf([&] { readFile(folder_); }), ExitCode::inputMissing);
}

TEST_F(File, PendingFile_Committed_ReplacesTheTargetAndLeavesNothingElse)
{
    write(folder_ / "out.png", "old");
    {
        PendingFile pending(folder_ / "out.png");
        write(pending.path(), "new");
        EXPECT_EQ(readFile(folder_ / "out.png"), "old");
        EXPECT_EQ(pending.path().extension(), ".png");
        pending.commit();
    }
    EXPECT_EQ(readFile(folder_ / "out.png"), "new");
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, PendingFile_NotCommitted_LeavesTheOldFileAlone)
{
    write(folder_ / "out", "old");
    {
        PendingFile pending(folder_ / "out");
        write(pending.path(), "half of the n");
    }
    EXPECT_EQ(readFile(folder_ / "out"), "old");
    EXPECT_EQ(filesInFolder(), 1u);
}

TEST_F(File, PendingFile_TwoForOneTarget_DoNotShareAName)
{
    PendingFile first(folder_ / "out"), second(folder_ / "out");
    EXPECT_NE(first.path(), second.path());
}

TEST_F(File, PendingFile_ObeysTheUmask)
{
    PendingFile(folder_ / "out").commit();
    const mode_t mask = ::umask(0);
    ::umask(mask);
    EXPECT_EQ(static_cast<unsigned>(fs::status(folder_ / "out").permissions()), 0666u & ~mask);
}

TEST_F(File, PendingFile_ThroughALink_ReplacesTheFileBehindIt)
{
    write(folder_ / "real", "old");
    fs::create_symlink(folder_ / "real", folder_ / "link");
    {
        PendingFile pending(folder_ / "link");
        write(pending.path(), "new");
        pending.commit();
    }
    EXPECT_TRUE(fs::is_symlink(folder_ / "link"));
    EXPECT_EQ(readFile(folder_ / "real"), "new");
}

TEST_F(File, PendingFile_WithoutItsFolder_IsCannotWrite)
{
    EXPECT_EQ(codeOf([&] { PendingFile pending(folder_ / "absent" / "out"); }), ExitCode::cannotWrite);
    EXPECT_EQ(codeOf([&] { PendingFile pending(""); }), ExitCode::cannotWrite);
}

TEST_F(File, PendingFile_OverAFolderOrDevice_IsCannotWrite)
{
    EXPECT_EQ(codeOf([&] { PendingFile pending(folder_); }), ExitCode::cannotWrite);
    EXPECT_EQ(codeOf([&] { PendingFile pending("/dev/null"); }), ExitCode::cannotWrite);
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

// The superuser may write anywhere but on a file system without files.
TEST_F(File, PendingFile_InAFolderThatTakesNoFiles_IsCannotWrite)
{
    EXPECT_EQ(codeOf([&] { PendingFile pending("/proc/self/out.png"); }), ExitCode::cannotWrite);
}

} // namespace
} // namespace dioptre
