// Small pictures of every kind, whole and forged, into a folder: what the picture target starts from.
#include "support/forged_pictures.h"

#include "base/picture.h"

#include <ImfRgbaFile.h>
#include <ImfTiledRgbaFile.h>
#include <fmt/format.h>
#include <stb_image_write.h>

#include <fstream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

Picture gradient(int width, int height)
{
    Picture picture = blankFloats(width, height);
    for (std::size_t i = 0; i < picture.floats.size(); ++i)
        picture.floats[i] = static_cast<float>(i % 97) / 64.0F;
    return picture;
}

// By every compression, in rows and in tiles.
void writeExrs(const std::filesystem::path& folder, int width, int height)
{
    std::vector<Imf::Rgba> pixels;
    for (int i = 0; i < width * height; ++i)
        pixels.emplace_back(static_cast<float>(i % 7) / 8.0F, static_cast<float>(i % 5) / 4.0F, 0.5F, 1.0F);
    const auto row = static_cast<std::size_t>(width);
    for (int kind = 0; kind < Imf::NUM_COMPRESSION_METHODS; ++kind) {
        const auto compression = static_cast<Imf::Compression>(kind);
        const Imf::Header header(width, height, 1.0F, {0.0F, 0.0F}, 1.0F, Imf::INCREASING_Y, compression);
        Imf::RgbaOutputFile rows((folder / fmt::format("rows{}.exr", kind)).c_str(), header, Imf::WRITE_RGBA);
        rows.setFrameBuffer(pixels.data(), 1, row);
        rows.writePixels(height);
        Imf::TiledRgbaOutputFile tiles((folder / fmt::format("tiles{}.exr", kind)).c_str(), header,
                                       Imf::WRITE_RGBA, 8, 8, Imf::MIPMAP_LEVELS);
        tiles.setFrameBuffer(pixels.data(), 1, row);
        tiles.writeTiles(0, tiles.numXTiles() - 1, 0, tiles.numYTiles() - 1);
    }
}

} // namespace

int main(int count, char** words)
{
    if (count != 2)
        return 2;
    const std::filesystem::path folder = words[1];
    const auto put = [&](const std::string& name, const std::string& bytes) {
        std::ofstream(folder / name, std::ios::binary) << bytes;
    };
    const Picture picture = gradient(12, 5);
    const Settings settings{{"Software", "dioptre"}, {"scene", "a ball"}};
    writePng(folder / "8.png", picture, {}, settings);
    writePng(folder / "16.png", picture, {.gamma = 1.0, .bits = 16}, settings);
    writeRadiance(folder / "a.hdr", picture, settings);
    writeExr(folder / "half.exr", picture, ExrDepth::half, settings);
    writeExr(folder / "full.exr", picture, ExrDepth::full, settings,
             {{"depth.Z", std::vector<float>(60, 2.0F)}});
    const std::vector<std::uint8_t> bytes = topDownBytes(picture, {});
    stbi_write_jpg((folder / "a.jpg").c_str(), picture.width, picture.height, 3, bytes.data(), 80);
    writeExrs(folder, 20, 17);
    put("forged.png", forgedPng(4, 3));
    put("deep.png", forgedPng(1, 2, 16));
    put("black.png", blackPng(640, 480));
    put("text.png", pngWithText(5000));
    put("forged.jpg", forgedJpeg(16, 16));
    put("forged.hdr", forgedRadiance("-Y 2 +X 8"));
    put("forged.exr", forgedExr({0, 0, 3, 3}, {0, 0, 3, 3}));
    put("offset.exr", forgedExr({1, 1, 2, 2}, {-1, 0, 3, 3}));
    put("tiles.exr", forgedExr({0, 0, 3, 3}, {0, 0, 3, 3},
                               exrAttribute("tiles", "tiledesc",
                                            littleEndian(2) + littleEndian(2) + std::string(1, '\0'), 9)));
}
