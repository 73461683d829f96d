#include "base/file.h"
#include "base/picture_writer.h"
#include "picture_fixture.h"

#include <csignal>
#include <functional>
#include <sys/resource.h>

namespace dioptre
{
namespace
{

constexpr int width = 37, height = 100;

const Settings writtenSettings = {{"dioptre.spp", "16"}, {"dioptre.set", "title=Sch\xC3\xB6n"}};

// Rows [first, first + count) of a picture, counted from the bottom.
Picture bandOf(const Picture& picture, int first, int count)
{
    const auto begin = picture.floats.begin() + 4 * picture.width * first;
    return floatPicture(picture.width, count, {begin, begin + 4 * picture.width * count});
}

ExrLayer bandOf(const ExrLayer& layer, int first, int count)
{
    const auto begin = layer.numbers.begin() + width * first;
    return {layer.channel, {begin, begin + width * count}};
}

std::vector<ExrLayer> twoLayers()
{
    std::vector<ExrLayer> layers = {{"depth.Z", {}}, {"object.id", {}}};
    for (int i = 0; i < width * height; ++i) {
        layers[0].numbers.push_back(0.37F * static_cast<float>(i));
        layers[1].numbers.push_back(static_cast<float>(i / 7));
    }
    return layers;
}

// The heights are used in turn until the picture is full.
void addBands(PictureWriter& writer, const Picture& picture, const std::vector<ExrLayer>& layers,
              const std::vector<int>& heights)
{
    int top = picture.height;
    for (std::size_t i = 0; top > 0; ++i) {
        const int rows = std::min(heights[i % heights.size()], top);
        top -= rows;
        std::vector<ExrLayer> bands;
        for (const ExrLayer& layer : layers)
            bands.push_back(bandOf(layer, top, rows));
        writer.add(bandOf(picture, top, rows), bands);
    }
}

using Opener = std::function<std::unique_ptr<PictureWriter>(const std::filesystem::path&)>;

const std::vector<Opener> openers = {
    [](const auto& path) { return openPng(path, width, height, {}, writtenSettings); },
    [](const auto& path) {
        return openPng(path, width, height, {true, 2.2, 16}, writtenSettings);
    },
    [](const auto& path) { return openRadiance(path, width, height, writtenSettings); },
    [](const auto& path) { return openExr(path, width, height, ExrDepth::half, writtenSettings); },
    [](const auto& path) { return openExr(path, width, height, ExrDepth::full, writtenSettings); },
};

const std::vector<std::vector<int>> bandings = {{1}, {7}, {16}, {1, 30, 2, 5}, {64, 36}, {height - 1, 1}};

// Whatever a file would take beyond so many bytes fails, as on a full disk.
class FullDisk
{
public:
    explicit FullDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
    {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk()
    {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    void (*handler_)(int);
    rlimit before_{};
};

TEST_F(PictureFile, PictureWriter_WhateverTheBands_WritesTheSameBytes)
{
    const Picture picture = renderLikePicture(width, height);
    for (std::size_t kind = 0; kind < openers.size(); ++kind) {
        auto whole = openers[kind](folder_ / "whole");
        whole->add(picture);
        whole->finish();
        const std::string expected = readFile(folder_ / "whole");
        for (const auto& heights : bandings) {
            auto writer = openers[kind](folder_ / "banded");
            addBands(*writer, picture, {}, heights);
            writer->finish();
            EXPECT_TRUE(readFile(folder_ / "banded") == expected)
                << "kind " << kind << ", bands of " << heights[0];
        }
    }
}

TEST_F(PictureFile, PictureWriter_OfLayers_WhateverTheBands_WritesTheSameBytes)
{
    const Picture picture = renderLikePicture(width, height);
    const std::vector<ExrLayer> layers = twoLayers();
    writeExr(folder_ / "whole.exr", picture, ExrDepth::half, writtenSettings, layers);
    for (const auto& heights : bandings) {
        auto writer = openExr(folder_ / "banded.exr", width, height, ExrDepth::half, writtenSettings,
                              {"depth.Z", "object.id"});
        addBands(*writer, picture, layers, heights);
        writer->finish();
        EXPECT_TRUE(readFile(folder_ / "banded.exr") == readFile(folder_ / "whole.exr"))
            << "bands of " << heights[0];
    }
}

TEST_F(PictureFile, PictureWriter_OfBytes_WhateverTheBands_WritesTheSameBytes)
{
    const Picture upper{2, 1, PixelFormat::srgb8, {1, 2, 3, 255, 4, 5, 6, 255}, {}};
    const Picture lower{2, 1, PixelFormat::srgb8, {7, 8, 9, 255, 10, 11, 12, 255}, {}};
    const auto writer = openPng(folder_ / "a.png", 2, 2, {}, {});
    writer->add(upper);
    writer->add(lower);
    writer->finish();
    EXPECT_EQ(readPicture(folder_ / "a.png").bytes,
              (std::vector<std::uint8_t>{7, 8, 9, 255, 10, 11, 12, 255, 1, 2, 3, 255, 4, 5, 6, 255}));
}

TEST_F(PictureFile, PictureWriter_BeforeItIsFinished_LeavesTheOldFileAlone)
{
    for (const auto& open : openers) {
        put("a", "old");
        {
            const auto writer = open(folder_ / "a");
            addBands(*writer, renderLikePicture(width, height), {}, {40});
            EXPECT_EQ(readFile(folder_ / "a"), "old");
        }
        EXPECT_EQ(readFile(folder_ / "a"), "old");
        const auto files = std::filesystem::directory_iterator(folder_);
        EXPECT_EQ(std::distance(begin(files), end(files)), 1);
    }
}

// At every size: within the head, within the rows, within the table of lines that an EXR ends with.
TEST_F(PictureFile, PictureWriter_OnAFullDisk_IsCannotWriteAndLeavesNothing)
{
    const Picture picture = renderLikePicture(width, height);
    for (const auto& open : openers) {
        const auto write = [&] {
            const auto writer = open(folder_ / "a");
            addBands(*writer, picture, {}, {7});
            writer->finish();
        };
        write();
        const auto size = std::filesystem::file_size(folder_ / "a");
        std::filesystem::remove(folder_ / "a");
        for (const auto bytes : {std::uintmax_t{0}, std::uintmax_t{100}, size / 2, size - 1}) {
            const FullDisk disk(bytes);
            try {
                write();
                ADD_FAILURE() << bytes << " bytes of " << size;
            } catch (const Error& error) {
                EXPECT_EQ(error.code(), ExitCode::cannotWrite);
                EXPECT_NE(std::string(error.what()).find("could not be written to its end: make room"),
                          std::string::npos)
                    << error.what();
            }
            EXPECT_TRUE(std::filesystem::is_empty(folder_));
        }
        const FullDisk disk(size);
        EXPECT_NO_THROW(write());
        std::filesystem::remove(folder_ / "a");
    }
}

TEST_F(PictureFile, PictureWriter_WithoutItsFolder_IsCannotWrite)
{
    for (const auto& open : openers)
        try {
            open(folder_ / "absent" / "a");
            ADD_FAILURE();
        } catch (const Error& error) {
            EXPECT_EQ(error.code(), ExitCode::cannotWrite);
        }
}

} // namespace
} // namespace dioptre
