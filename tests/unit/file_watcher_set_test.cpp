#include "base/error.h"
#include "file_watcher_fixture.h"

#include <atomic>
#include <sys/resource.h>

namespace dioptre
{
namespace
{

class FileWatcherSet : public FileWatching
{
protected:
    FileWatcherSet()
    {
        save("a");
        save("b");
        watch({"a", "b", "mark"});
    }

    // What the kernel holds of this process' watches: number, file and mask, a line each.
    static std::vector<std::string> kernelWatches()
    {
        std::vector<std::string> watches;
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fdinfo")) {
            std::ifstream info(entry.path());
            for (std::string line; std::getline(info, line);)
                if (line.starts_with("inotify "))
                    watches.push_back(line);
        }
        std::sort(watches.begin(), watches.end());
        return watches;
    }
    // The same without the numbers.
    static std::vector<std::string> watchedThings()
    {
        std::vector<std::string> watches = kernelWatches();
        for (std::string& watch : watches)
            watch.erase(0, watch.find(" ino:"));
        std::sort(watches.begin(), watches.end());
        return watches;
    }
};

} // namespace

TEST_F(FileWatcherSet, WatchedAgain_LosesNoSave)
{
    for (int time = 0; time < 20; ++time) {
        save("a");
        watch({"mark", "b", "a"});
        EXPECT_EQ(told(), Names{"a"});
    }
}

TEST_F(FileWatcherSet, WatchedAgain_LosesNothingThatIsNotFetchedYet)
{
    save("a");
    {
        std::unique_lock lock(mutex_);
        ASSERT_TRUE(woken_.wait_for(lock, std::chrono::seconds(30), [&] { return isWoken_; }));
    }
    watch({"a", "mark"});
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSet, WatchedAgain_LosesNoRemoval)
{
    remove("a");
    watch({"a", "b", "mark"});
    EXPECT_EQ(toldAtLength(), Names{"a"});
}

TEST_F(FileWatcherSet, WatchedAgain_KeepsTheKernelsWatches)
{
    const auto before = kernelWatches();
    EXPECT_GT(before.size(), 3U);
    watch({"a", "b", "mark"});
    EXPECT_EQ(kernelWatches(), before);
    watch({"a", "b", "c", "mark"});
    watch({"a", "b", "mark"});
    EXPECT_EQ(kernelWatches(), before);
}

TEST_F(FileWatcherSet, FilesThatJoin_AreToldAndThoseThatLeaveAreNot)
{
    save("c");
    watch({"b", "c", "mark"});
    save("a");
    save("b");
    save("c");
    EXPECT_EQ(told(), (Names{"b", "c"}));
}

TEST_F(FileWatcherSet, Emptied_LeavesTheKernelNoWatch)
{
    watch({});
    EXPECT_EQ(kernelWatches(), std::vector<std::string>{});
}

// Nothing that is not needed may wake the thread.
TEST_F(FileWatcherSet, AfterManyChanges_TheKernelHoldsWhatANewSetWouldAsk)
{
    watch({"one/two/a", "b", "link", "mark"});
    makeFolder("one/two");
    save("one/two/a");
    link("b", "link");
    EXPECT_EQ(told(), (Names{"link", "one/two/a"}));
    saveByRename("one/two/a");
    saveByRename("b");
    EXPECT_EQ(told(), (Names{"b", "link", "one/two/a"}));
    const auto grown = watchedThings();
    watch({});
    watch({"one/two/a", "b", "link", "mark"});
    EXPECT_EQ(grown, watchedThings());
}

// The thread is held up in `wake` while more happens than the kernel keeps.
TEST_F(FileWatcherSet, EventsThatWereLost_TellOfAll)
{
    int limit = 0;
    std::ifstream("/proc/sys/fs/inotify/max_queued_events") >> limit;
    if (limit < 1 || limit > 100000)
        GTEST_SKIP() << "the kernel keeps " << limit << " events";
    save("c");
    watch({"a", "b", "none", "mark"});
    {
        const std::scoped_lock held(mutex_);
        save("mark");
        for (int i = 0; i < limit; ++i) { // two events each; equal ones would be joined
            move("c", "d");
            move("d", "c");
        }
        saveByRename("a"); // is lost, and with it that another file is there
    }
    EXPECT_EQ(toldUntil("a"), (Names{"a", "b", "mark"}));
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

TEST_F(FileWatcherSet, UsedByManyThreads_TellsTheLastSave)
{
    std::atomic<bool> isDone = false;
    std::vector<std::thread> threads;
    for (int i = 0; i < 3; ++i)
        threads.emplace_back([&, i] {
            while (!isDone)
                watch(i == 0 ? Names{"a", "b", "mark"} : Names{"a", "mark"});
        });
    for (int i = 0; i < 50; ++i)
        saveByRename("b");
    save("a");
    toldUntil("a");
    isDone = true;
    for (std::thread& thread : threads)
        thread.join();
    save("a");
    EXPECT_EQ(told(), Names{"a"});
}

// The counter is gone with it: sanitizers see a call that comes too late.
TEST_F(FileWatcherSet, Destroyed_CallsNoMore)
{
    for (int time = 0; time < 50; ++time) {
        auto count = std::make_unique<std::atomic<int>>(0);
        {
            FileWatcher watcher([&] { ++*count; });
            watcher.watch({at("a"), at("b")});
            save("a");
            remove("b");
        }
        const int before = *count;
        save("a");
        save("b");
        EXPECT_EQ(told(), (Names{"a", "b"}));
        EXPECT_EQ(*count, before);
    }
}

TEST_F(FileWatcherSet, WithoutDescriptors_IsRefusedWithTheMend)
{
#ifdef __SANITIZE_ADDRESS__
    GTEST_SKIP() << "the sanitizer's own look at an Error needs a pipe";
#endif
    rlimit before{};
    ::getrlimit(RLIMIT_NOFILE, &before);
    const int next = ::dup(0);
    ::close(next);
    for (int left = 0; left < 2; ++left) {
        const rlimit few{static_cast<rlim_t>(next + left), before.rlim_max};
        ::setrlimit(RLIMIT_NOFILE, &few);
        try {
            const FileWatcher watcher([] {});
            ADD_FAILURE() << "with " << left << " left";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::retry);
            EXPECT_NE(std::string(error.what()).find("ulimit -n"), std::string::npos) << error.what();
        }
        ::setrlimit(RLIMIT_NOFILE, &before);
    }
}

} // namespace dioptre
