#include "file_watcher_fixture.h"

namespace dioptre
{
namespace
{

class FileWatcherPaths : public FileWatching
{
};

} // namespace

TEST_F(FileWatcherPaths, FolderMovedAwayAndBack_IsToldEachTime)
{
    makeFolder("one/two");
    save("one/two/a");
    watch({"one/two/a", "mark"});
    move("one", "gone");
    EXPECT_EQ(toldAtLength(), Names{"one/two/a"});
    save("gone/two/a"); // no longer its path
    EXPECT_EQ(toldAtLength(), Names{});
    move("gone", "one");
    EXPECT_EQ(told(), Names{"one/two/a"});
    save("one/two/a");
    EXPECT_EQ(told(), Names{"one/two/a"});
}

TEST_F(FileWatcherPaths, AnotherFolderInItsPlace_IsTold)
{
    makeFolder("one");
    makeFolder("new");
    save("one/a");
    save("new/a");
    watch({"one/a", "mark"});
    move("one", "old");
    move("new", "one");
    EXPECT_EQ(told(), Names{"one/a"});
    save("one/a");
    EXPECT_EQ(told(), Names{"one/a"});
    save("old/a");
    EXPECT_EQ(toldAtLength(), Names{});
}

TEST_F(FileWatcherPaths, FolderRemovedAndMadeAnew_IsTold)
{
    makeFolder("one");
    save("one/a");
    watch({"one/a", "mark"});
    remove("one");
    EXPECT_EQ(toldAtLength(), Names{"one/a"});
    makeFolder("one");
    EXPECT_EQ(toldAtLength(), Names{});
    save("one/a");
    EXPECT_EQ(told(), Names{"one/a"});
}

TEST_F(FileWatcherPaths, FoldersThatAreMissing_AreAwaited)
{
    watch({"one/two/three/a", "one/b", "mark"});
    makeFolder("one/two/three");
    save("one/two/three/a");
    save("one/b");
    EXPECT_EQ(told(), (Names{"one/b", "one/two/three/a"}));
    saveByRename("one/two/three/a");
    EXPECT_EQ(told(), Names{"one/two/three/a"});
}

TEST_F(FileWatcherPaths, WholeTreeMovedToAMissingFolder_IsTold)
{
    watch({"one/two/a", "one/two/none", "mark"});
    makeFolder("new/two");
    save("new/two/a");
    move("new", "one");
    EXPECT_EQ(toldAtLength(), Names{"one/two/a"});
}

TEST_F(FileWatcherPaths, WriterUnderWayInANewFolder_IsNotTold)
{
    watch({"one/a", "mark"});
    makeFolder("new");
    UnderWay writer(at("new/a"));
    move("new", "one");
    EXPECT_EQ(toldAtLength(), Names{});
    writer.end();
    EXPECT_EQ(told(), Names{"one/a"});
}

TEST_F(FileWatcherPaths, AFileWhereAFolderIsAwaited_IsNotTold)
{
    watch({"one/a", "mark"});
    save("one");
    EXPECT_EQ(toldAtLength(), Names{});
    remove("one");
    makeFolder("one");
    save("one/a");
    EXPECT_EQ(told(), Names{"one/a"});
}

TEST_F(FileWatcherPaths, LinkedFile_IsToldWhereItIsSaved)
{
    makeFolder("far");
    save("far/a");
    link("far/a", "link");
    watch({"link", "mark"});
    save("far/a");
    EXPECT_EQ(told(), Names{"link"});
    saveByRename("far/a");
    EXPECT_EQ(told(), Names{"link"});
    save("link");
    EXPECT_EQ(told(), Names{"link"});
    remove("far/a");
    EXPECT_EQ(toldAtLength(), Names{"link"});
}

TEST_F(FileWatcherPaths, LinkRetargeted_IsToldAndFollowed)
{
    save("a");
    save("b");
    link("a", "link");
    watch({"link", "mark"});
    link("b", "link~");
    move("link~", "link");
    EXPECT_EQ(told(), Names{"link"});
    save("a");
    EXPECT_EQ(told(), Names{});
    save("b");
    EXPECT_EQ(told(), Names{"link"});
    remove("link");
    link("a", "link");
    EXPECT_EQ(told(), Names{"link"});
    save("a");
    EXPECT_EQ(told(), Names{"link"});
}

TEST_F(FileWatcherPaths, LinkReplacedByAFileAndBack_IsTold)
{
    save("a");
    link("a", "link");
    watch({"link", "mark"});
    saveByRename("link");
    EXPECT_EQ(told(), Names{"link"});
    save("a");
    EXPECT_EQ(told(), Names{});
    remove("link");
    link("a", "link");
    EXPECT_EQ(told(), Names{"link"});
}

TEST_F(FileWatcherPaths, LinkedFolder_IsFollowedAndItsRetargetingTold)
{
    makeFolder("one");
    makeFolder("two");
    save("one/a");
    save("two/a");
    link("one", "link");
    watch({"link/a", "mark"});
    save("one/a");
    EXPECT_EQ(told(), Names{"link/a"});
    link("two", "link~");
    move("link~", "link");
    EXPECT_EQ(told(), Names{"link/a"});
    save("one/a");
    EXPECT_EQ(told(), Names{});
    saveByRename("two/a");
    EXPECT_EQ(told(), Names{"link/a"});
}

TEST_F(FileWatcherPaths, LinksToLinksUpwardAndAbsolute_AreFollowed)
{
    makeFolder("far/deep");
    makeFolder("near");
    save("far/a");
    link("../far/deep", "near/deep");
    link(at("near/deep").string() + "/../a", "link"); // .. is of what the link leads to
    watch({"link", "mark"});
    save("far/a");
    EXPECT_EQ(told(), Names{"link"});
    remove("near/deep");
    EXPECT_EQ(toldAtLength(), Names{"link"});
    link("../far/deep", "near/deep");
    EXPECT_EQ(told(), Names{"link"});
}

TEST_F(FileWatcherPaths, LinkToNothing_IsToldOnceItsFileIsThere)
{
    link("far/a", "link");
    watch({"link", "mark"});
    makeFolder("far");
    EXPECT_EQ(toldAtLength(), Names{});
    save("far/a");
    EXPECT_EQ(told(), Names{"link"});
}

TEST_F(FileWatcherPaths, LinksInACircle_AreHarmless)
{
    link("two", "one");
    link("one", "two");
    watch({"one", "one/a", "mark"});
    EXPECT_EQ(toldAtLength(), Names{});
    remove("one");
    save("one");
    EXPECT_EQ(told(), Names{"one"});
}

// As a name it stays relative.
TEST_F(FileWatcherPaths, ARelativePath_IsOfTheWorkingFolder)
{
    save("a");
    const auto relative = std::filesystem::relative(at("a"));
    ASSERT_TRUE(relative.is_relative());
    watcher_.watch({relative, ""});
    save("a");
    std::unique_lock lock(mutex_);
    ASSERT_TRUE(woken_.wait_for(lock, std::chrono::seconds(30), [&] { return isWoken_; }));
    EXPECT_EQ(watcher_.changed(), std::vector{relative});
}

} // namespace dioptre
