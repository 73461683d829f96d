#include "file_watcher_fixture.h"

namespace dioptre
{
namespace
{

class FileWatcherSaves : public FileWatching
{
protected:
    FileWatcherSaves()
    {
        save("a");
        save("b");
        watch({"a", "b", "mark"});
    }
};

} // namespace

TEST_F(FileWatcherSaves, WrittenInPlace_IsTold)
{
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, RenamedOver_IsTold)
{
    saveByRename("a");
    EXPECT_EQ(told(), Names{"a"});
    saveByRename("a"); // the new file is watched as the old was
    EXPECT_EQ(told(), Names{"a"});
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

// As vim does with backupcopy=no.
TEST_F(FileWatcherSaves, MovedToABackupAndWrittenAnew_IsTold)
{
    move("a", "a~");
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, RemovedAndWrittenAnew_IsTold)
{
    remove("a");
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, TruncatedFirst_IsToldWithItsContent)
{
    save("a", "");
    toldUntil("a");
    save("a", "new");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, TwiceWithinASecond_IsToldTwice)
{
    for (int time = 0; time < 5; ++time) {
        save("a", "as long");
        EXPECT_EQ(toldUntil("a"), Names{"a"});
    }
}

TEST_F(FileWatcherSaves, SeveralAtOnce_AreToldSorted)
{
    save("b");
    saveByRename("a");
    save("b");
    EXPECT_EQ(told(), (Names{"a", "b"}));
}

TEST_F(FileWatcherSaves, WriterUnderWay_IsNotTold)
{
    UnderWay writer(at("a"));
    EXPECT_EQ(told(), Names{});
    writer.put("more");
    EXPECT_EQ(told(), Names{});
    writer.end();
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, CreatedAndUnderWayForLong_IsNotTold)
{
    remove("a");
    UnderWay writer(at("a"));
    EXPECT_EQ(toldAtLength(), Names{});
    writer.end();
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, OtherTimeOrMode_IsNotTold)
{
    std::filesystem::permissions(at("a"), std::filesystem::perms::owner_all);
    std::filesystem::last_write_time(at("b"), {});
    EXPECT_EQ(toldAtLength(), Names{});
}

TEST_F(FileWatcherSaves, ReadOrSavedBesides_IsNotTold)
{
    std::ifstream(at("a")).get();
    save("c");
    saveByRename("aa");
    makeFolder("d");
    EXPECT_EQ(toldAtLength(), Names{});
}

TEST_F(FileWatcherSaves, Vanished_IsToldAndAgainOnceItReturns)
{
    remove("a");
    move("b", "c");
    EXPECT_EQ(toldAtLength(), (Names{"a", "b"}));
    save("a");
    move("c", "b");
    EXPECT_EQ(told(), (Names{"a", "b"}));
}

TEST_F(FileWatcherSaves, AFolderInItsPlace_IsTold)
{
    remove("a");
    makeFolder("a");
    EXPECT_EQ(toldAtLength(), Names{"a"});
    remove("a");
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSaves, LinkedToItsName_IsTold)
{
    remove("a");
    save("c");
    std::filesystem::create_hard_link(at("c"), at("a"));
    EXPECT_EQ(told(), Names{"a"});
}

// Nothing but the absence of a writer tells it from a file that is being created.
TEST_F(FileWatcherSaves, LinkedToItsNameAndTheOtherNameRemoved_IsTold)
{
    remove("a");
    save("c");
    std::filesystem::create_hard_link(at("c"), at("a"));
    remove("c");
    EXPECT_EQ(toldAtLength(), Names{"a"});
}

// linkat(2) of a file that has had no name; its writer has closed it before that can be watched.
TEST_F(FileWatcherSaves, WrittenWithoutANameAndLinked_IsTold)
{
    remove("a");
    const int file = ::open(folder_.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0644);
    if (file < 0)
        GTEST_SKIP() << "this file system has no files without names";
    EXPECT_EQ(::write(file, "text", 4), 4);
    const std::string from = "/proc/self/fd/" + std::to_string(file);
    EXPECT_EQ(::linkat(AT_FDCWD, from.c_str(), AT_FDCWD, at("a").c_str(), AT_SYMLINK_FOLLOW), 0);
    ::close(file);
    EXPECT_EQ(toldAtLength(), Names{"a"});
}

TEST_F(FileWatcherSaves, HardLinkedElsewhere_IsToldWhenWrittenThere)
{
    makeFolder("other");
    std::filesystem::create_hard_link(at("a"), at("other/name"));
    save("other/name");
    EXPECT_EQ(told(), Names{"a"});
    saveByRename("other/name"); // another file now
    save("other/name");
    EXPECT_EQ(toldAtLength(), Names{});
}

TEST_F(FileWatcherSaves, TwoNamesOfOneFile_AreBothTold)
{
    std::filesystem::create_hard_link(at("a"), at("c"));
    link("a", "d");
    watch({"a", "c", "d", "mark"});
    save("a");
    EXPECT_EQ(told(), (Names{"a", "c", "d"}));
}

} // namespace dioptre
