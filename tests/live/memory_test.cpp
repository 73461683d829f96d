// What is remembered of an input comes back whole, or not at all.
#include "live/memory.h"

#include "base/error.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <vector>

namespace dioptre::test
{
namespace
{

namespace fs = std::filesystem;

// Puts an environment variable back when it goes.
class Variable
{
public:
    explicit Variable(const char* name) : name_(name)
    {
        if (const char* value = std::getenv(name))
            before_ = value;
    }
    Variable(const Variable&) = delete;
    Variable& operator=(const Variable&) = delete;
    ~Variable()
    {
        set(before_);
    }
    void set(const std::optional<std::string>& value) const
    {
        if (value)
            ::setenv(name_, value->c_str(), 1);
        else
            ::unsetenv(name_);
    }

private:
    const char* name_;
    std::optional<std::string> before_;
};

Remembered moved()
{
    Remembered what;
    what.size_px = {640, 361};
    what.panel = false;
    Camera hand;
    hand.eye = {0.1, -1e-17, 1.0 / 3.0};
    hand.target = {1e9, 0.0, -2.5};
    hand.fovY_deg = 41.99999999999;
    what.hand = hand;
    what.own.eye = {3.0, 2.0, 1.0};
    return what;
}

void expectSame(const Camera& actual, const Camera& expected)
{
    EXPECT_EQ(actual.eye, expected.eye);
    EXPECT_EQ(actual.target, expected.target);
    EXPECT_EQ(actual.fovY_deg, expected.fovY_deg);
}

class Memory : public InAFolder
{
protected:
    Memory()
    {
        state_.set((folder / "state").string());
        std::ofstream(input()) << "";
    }
    fs::path input() const
    {
        return folder / "a.toml";
    }
    fs::path file() const // the one that was written
    {
        return fs::directory_iterator(folder / "state" / "dioptre")->path();
    }
    std::vector<std::string> names() const // all that the folder holds
    {
        std::vector<std::string> all;
        for (const auto& entry : fs::directory_iterator(folder))
            all.push_back(entry.path().filename().string());
        std::ranges::sort(all);
        return all;
    }

    Variable state_{"XDG_STATE_HOME"};
    Variable home_{"HOME"};
};

} // namespace

TEST_F(Memory, NothingKept_NothingRecalled)
{
    EXPECT_FALSE(recall(input()));
    EXPECT_EQ(names(), (std::vector<std::string>{"a.toml"})) << "a look makes no folder";
}

// To the last bit: a scene's own camera is told by being the same.
TEST_F(Memory, Kept_IsRecalledBitForBit)
{
    remember(input(), moved());
    const auto recalled = recall(input());
    ASSERT_TRUE(recalled);
    EXPECT_EQ(recalled->size_px, moved().size_px);
    EXPECT_FALSE(recalled->panel);
    ASSERT_TRUE(recalled->hand);
    expectSame(*recalled->hand, *moved().hand);
    expectSame(recalled->own, moved().own);
}

TEST_F(Memory, CameraNotMoved_NoneRecalled_AndTheLatestCounts)
{
    remember(input(), moved());
    remember(input(), {{10, 20}, true, {}, {}});
    const auto recalled = recall(input());
    ASSERT_TRUE(recalled);
    EXPECT_EQ(recalled->size_px, glm::ivec2(10, 20));
    EXPECT_TRUE(recalled->panel);
    EXPECT_FALSE(recalled->hand);
}

TEST_F(Memory, EachInput_HasItsOwn_ByWhateverNameItIsCalled)
{
    remember(input(), moved());
    EXPECT_FALSE(recall(folder / "b.toml"));
    EXPECT_TRUE(recall(folder / "." / "a.toml"));
    fs::create_symlink("a.toml", folder / "link.toml");
    EXPECT_TRUE(recall(folder / "link.toml"));
}

TEST_F(Memory, IsKeptInTheStateFolder_AndNothingBesideTheInput)
{
    remember(input(), moved());
    EXPECT_EQ(names(), (std::vector<std::string>{"a.toml", "state"}));
    EXPECT_EQ(file().extension(), ".json");
}

TEST_F(Memory, DamagedFile_IsNoneAtAll_AndIsReplaced)
{
    for (const std::string text :
         {"", "{", "null", "[]", "7", "{}", "\xff\xfe", R"({"width": 1})",
          R"({"width": "a", "height": 2, "panel": true})", R"({"width": 1, "height": 2, "panel": 3})",
          R"({"width": 1, "height": 2, "panel": true, "camera": 1})",
          R"({"width": 1, "height": 2, "panel": true, "camera": {"eye": [1, 2]}})",
          R"({"width": 1e999, "height": 2, "panel": true})"}) {
        remember(input(), moved());
        std::ofstream(file()) << text;
        EXPECT_FALSE(recall(input())) << text;
        remember(input(), moved());
        EXPECT_TRUE(recall(input())) << text;
    }
}

TEST_F(Memory, SizeThatNoWindowHas_IsNone)
{
    for (const std::string size : {"-3", "0", "1e300", "4294967297", "16385", "0.5"}) {
        remember(input(), moved());
        std::ofstream(file()) << R"({"width": )" << size << R"(, "height": 200, "panel": true})";
        const auto recalled = recall(input());
        ASSERT_TRUE(recalled) << size;
        EXPECT_EQ(recalled->size_px, glm::ivec2(0)) << size;
    }
}

TEST_F(Memory, RelativeStateFolder_IsNotUsed)
{
    state_.set("state");
    home_.set(folder.string());
    remember(input(), moved());
    EXPECT_TRUE(fs::is_directory(folder / ".local" / "state" / "dioptre"));
    EXPECT_TRUE(recall(input()));
}

TEST_F(Memory, NoHome_NothingIsKeptAndNothingFails)
{
    state_.set(std::nullopt);
    for (const auto& home : {std::optional<std::string>(), std::optional<std::string>("")}) {
        home_.set(home);
        EXPECT_NO_THROW(remember(input(), moved()));
        EXPECT_FALSE(recall(input()));
    }
}

TEST_F(Memory, StateFolderThatCannotBeMade_IsTold)
{
    std::ofstream(folder / "state") << "a file";
    EXPECT_FALSE(recall(input()));
    try {
        remember(input(), moved());
        ADD_FAILURE() << "it says nothing";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::cannotWrite);
    }
}

// A window may be closed after the folder that it was opened in.
TEST_F(Memory, InputInAFolderThatIsGone_DoesNotEndTheProgram)
{
    const fs::path here = fs::current_path();
    fs::create_directory(folder / "gone");
    fs::current_path(folder / "gone");
    fs::remove(folder / "gone");
    EXPECT_NO_THROW(remember("a.toml", moved()));
    EXPECT_NO_THROW(recall("a.toml"));
    fs::current_path(here);
}

} // namespace dioptre::test
