#include "base/picture_cache.h"

#include "picture_fixture.h"

#include <bit>
#include <chrono>
#include <iterator>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// A picture file that has lain there for an hour, and a cache beside it.
class Cache : public PictureFile
{
protected:
    Cache() : file_(put("a.png", "three")), kept_(folder_ / "cache")
    {
        age(file_);
    }

    static void age(const fs::path& file, int hours = 1)
    {
        fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(hours));
    }

    // A picture with levels of all formats; `seed` makes it one or another.
    static std::vector<Picture> levels(std::uint8_t seed)
    {
        return {{2, 1, PixelFormat::srgb8, {seed, 2, 3, 4, 5, 6, 7, 255}, {}},
                {1, 1, PixelFormat::linear8, {9, 8, 7, 6}, {}},
                {1, 2, PixelFormat::float32, {}, {1.0f, -0.0f, 65504.0f, 1e-40f, 5, 6, 7, 8}}};
    }

    // Asks for the file's levels, which are made of `seed` where they are not kept.
    std::vector<Picture> ask(const PictureCache& cache, std::uint8_t seed, const char* preparation = "p")
    {
        return cache.levelsOf(file_, preparation, [&] {
            ++made_;
            return levels(seed);
        });
    }

    std::vector<fs::path> entries() const
    {
        std::vector<fs::path> found;
        for (const auto& entry : fs::directory_iterator(kept_))
            found.push_back(entry.path());
        return found;
    }

    fs::path file_;
    fs::path kept_;
    int made_ = 0;
};

// By bits: -0 is not 0.
bool sameBits(const std::vector<float>& a, const std::vector<float>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
        return std::bit_cast<std::uint32_t>(x) == std::bit_cast<std::uint32_t>(y);
    });
}

bool alike(const std::vector<Picture>& a, const std::vector<Picture>& b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Picture& x, const Picture& y) {
        return x.width == y.width && x.height == y.height && x.format == y.format && x.bytes == y.bytes &&
               sameBits(x.floats, y.floats);
    });
}

TEST_F(Cache, SecondTime_GivesTheSameBitsWithoutMakingThem)
{
    const PictureCache cache(kept_);
    EXPECT_TRUE(alike(ask(cache, 1), levels(1)));
    EXPECT_TRUE(alike(ask(cache, 2), levels(1)));
    EXPECT_EQ(made_, 1);
}

TEST_F(Cache, AnotherPreparation_IsKeptApart)
{
    const PictureCache cache(kept_);
    ask(cache, 1, "mipmaps");
    EXPECT_TRUE(alike(ask(cache, 2, "sky"), levels(2)));
    EXPECT_TRUE(alike(ask(cache, 3, "mipmaps"), levels(1)));
}

TEST_F(Cache, ChangedFile_IsMadeAnew)
{
    const PictureCache cache(kept_);
    ask(cache, 1);
    put("a.png", "four!"); // of the same size
    age(file_, 2);
    EXPECT_TRUE(alike(ask(cache, 2), levels(2)));
}

TEST_F(Cache, FileOfTheSameSizeAndTimePutInItsPlace_IsMadeAnew)
{
    const PictureCache cache(kept_);
    ask(cache, 1);
    const auto written = fs::last_write_time(file_);
    put("b.png", "four!");
    fs::rename(folder_ / "b.png", file_);
    fs::last_write_time(file_, written);
    EXPECT_TRUE(alike(ask(cache, 2), levels(2)));
}

// Its next edit might leave all its times as they are.
TEST_F(Cache, FileWrittenJustNow_IsNotKept)
{
    put("a.png", "three");
    ask(PictureCache(kept_), 1);
    EXPECT_FALSE(fs::exists(kept_));
}

TEST_F(Cache, DamagedEntry_IsPassedOverAndReplaced)
{
    const PictureCache cache(kept_);
    ask(cache, 1);
    const fs::path entry = entries().at(0);
    std::ifstream in(entry, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(in), {}};
    const auto tryWith = [&](const std::string& bytes, const std::string& what) {
        std::ofstream(entry, std::ios::binary | std::ios::trunc) << bytes;
        EXPECT_TRUE(alike(ask(cache, 2), levels(2))) << what;
        EXPECT_TRUE(alike(ask(cache, 3), levels(2))) << what << ", then replaced";
    };
    for (std::size_t size = 0; size < whole.size(); ++size)
        tryWith(whole.substr(0, size), std::to_string(size) + " bytes");
    for (std::size_t at = 0; at < whole.size(); ++at) {
        std::string flipped = whole;
        flipped[at] = static_cast<char>(flipped[at] ^ 0x40);
        tryWith(flipped, "flipped bit in byte " + std::to_string(at));
    }
    tryWith(whole + '\0', "a byte too many");
    tryWith("something else", "another's file");
}

TEST_F(Cache, FolderThatCannotBeMade_IsNoError)
{
    put("file", "not a folder");
    EXPECT_TRUE(alike(ask(PictureCache(folder_ / "file"), 1), levels(1)));
    EXPECT_TRUE(alike(ask(PictureCache(folder_ / "file" / "below"), 2), levels(2)));
}

TEST_F(Cache, WithoutFolder_KeepsNothing)
{
    ask({}, 1);
    EXPECT_TRUE(alike(ask({}, 2), levels(2)));
}

TEST_F(Cache, WhatMakeThrows_IsThrownAndNotKept)
{
    const PictureCache cache(kept_);
    const auto broken = [this]() -> std::vector<Picture> {
        fail(ExitCode::badInput, {file_.string()}, "is broken", "mend it");
    };
    EXPECT_THROW(cache.levelsOf(file_, "p", broken), Error);
    EXPECT_TRUE(alike(ask(cache, 1), levels(1)));
}

TEST_F(Cache, FullFolder_LosesWhatWasUnusedForLongest)
{
    const PictureCache unbounded(kept_);
    ask(unbounded, 1, "p1");
    const auto bytes = fs::file_size(entries().at(0));
    put("cache/mine.txt", std::string(10 * bytes, 'x')); // not the cache's: neither counted nor removed
    age(kept_ / "mine.txt", 9);
    age(entries().at(0).extension() == ".txt" ? entries().at(1) : entries().at(0), 3);
    const PictureCache cache(kept_, 2 * bytes);
    ask(cache, 2, "p2");
    ask(cache, 3, "p1"); // used: p2 is now the older one
    for (const auto& entry : entries())
        EXPECT_LT(fs::file_time_type::clock::now() - fs::last_write_time(entry),
                  std::chrono::hours(entry.extension() == ".txt" ? 10 : 1));
    ask(cache, 4, "p3");
    EXPECT_EQ(entries().size(), 3U);
    EXPECT_TRUE(alike(ask(cache, 5, "p1"), levels(1)));
    EXPECT_TRUE(alike(ask(cache, 6, "p2"), levels(6)));
    EXPECT_TRUE(fs::exists(kept_ / "mine.txt"));
}

TEST_F(Cache, PictureLargerThanTheBound_IsNotKept)
{
    ask(PictureCache(kept_, 10), 1);
    EXPECT_FALSE(fs::exists(kept_));
}

} // namespace
} // namespace dioptre
