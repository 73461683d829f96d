// What the tests of picture files share.
#pragma once

#include "base/error.h"
#include "base/picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <unistd.h>
#include <vector>

namespace dioptre
{

// A folder of its own for each test, removed afterwards.
class PictureFile : public testing::Test
{
protected:
    PictureFile()
        : folder_(std::filesystem::path(testing::TempDir()) /
                  ("dioptre-picture-" + std::to_string(::getpid())))
    {
        std::filesystem::create_directories(folder_);
    }
    ~PictureFile() override
    {
        std::filesystem::remove_all(folder_);
    }

    std::filesystem::path put(const std::string& name, const std::string& bytes) const
    {
        std::ofstream(folder_ / name, std::ios::binary) << bytes;
        return folder_ / name;
    }

    std::filesystem::path folder_;
};

inline Picture floatPicture(int width, int height, const std::vector<float>& rgba)
{
    return {width, height, PixelFormat::float32, {}, rgba};
}

// Smooth with a little noise, as a render is; one seed.
inline Picture renderLikePicture(int width, int height)
{
    Picture picture = floatPicture(width, height, {});
    std::mt19937 random(7);
    std::uniform_real_distribution<float> noise(0.0f, 0.004f);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float across = static_cast<float>(x) / static_cast<float>(width);
            const float up = static_cast<float>(y) / static_cast<float>(height);
            for (const float value : {across, up, 0.5f * (across + up)})
                picture.floats.push_back(value + noise(random));
            picture.floats.push_back(1.0f);
        }
    return picture;
}

// Every way in which a file can be cut short must be an error that names it, but for its last `harmless`
// bytes.
inline void expectEveryCutRefused(const std::filesystem::path& path, const std::string& bytes,
                                  std::size_t harmless = 0)
{
    const std::size_t step = std::max<std::size_t>(1, bytes.size() / 200);
    for (std::size_t size = 0; size < bytes.size() - harmless; size += step) {
        std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes.substr(0, size);
        try {
            readPicture(path);
            ADD_FAILURE() << "accepted with " << size << " of " << bytes.size() << " bytes";
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::badInput);
            EXPECT_TRUE(std::string(error.what()).starts_with(path.string() + ": ")) << error.what();
        }
    }
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
    EXPECT_NO_THROW(readPicture(path));
}

inline void expectRefused(const std::filesystem::path& path, const std::string& words)
{
    try {
        readPicture(path);
        ADD_FAILURE() << path << " was accepted";
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::badInput);
        EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
    }
}

} // namespace dioptre
