#include "picture_fixture.h"

#include <spng.h>
#include <stb_image_write.h>

#include <cstdlib>
#include <memory>

namespace dioptre
{
namespace
{

// A PNG by libspng alone, so that writePng is not its own judge. `gamma` 0 leaves gAMA out.
std::string pngBytes(int width, int height, std::uint8_t depth, std::uint8_t colourType, std::uint32_t gamma,
                     const void* numbers, std::size_t size)
{
    const std::unique_ptr<spng_ctx, void (*)(spng_ctx*)> context(spng_ctx_new(SPNG_CTX_ENCODER),
                                                                 &spng_ctx_free);
    spng_set_option(context.get(), SPNG_ENCODE_TO_BUFFER, 1);
    spng_ihdr header{
        static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), depth, colourType, 0, 0, 0};
    spng_set_ihdr(context.get(), &header);
    if (gamma != 0)
        spng_set_gama_int(context.get(), gamma);
    EXPECT_EQ(spng_encode_image(context.get(), numbers, size, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE), 0);
    std::size_t length = 0;
    int outcome = 0;
    const std::unique_ptr<void, void (*)(void*)> buffer(spng_get_png_buffer(context.get(), &length, &outcome),
                                                        &std::free);
    return {static_cast<const char*>(buffer.get()), length};
}

// Red above blue: the file's first row is the top.
std::string redAboveBluePng(std::uint32_t gamma)
{
    const std::uint8_t rgb[] = {255, 0, 0, 0, 0, 128};
    return pngBytes(1, 2, 8, SPNG_COLOR_TYPE_TRUECOLOR, gamma, rgb, sizeof rgb);
}

void appendBytes(void* text, void* bytes, int size)
{
    static_cast<std::string*>(text)->append(static_cast<const char*>(bytes), static_cast<std::size_t>(size));
}

TEST_F(PictureFile, Png_FirstRowOfTheFile_IsTheLastOfThePicture)
{
    const Picture picture = readPicture(put("a.png", redAboveBluePng(0)));
    EXPECT_EQ(picture.format, PixelFormat::srgb8);
    EXPECT_EQ(picture.bytes, (std::vector<std::uint8_t>{0, 0, 128, 255, 255, 0, 0, 255}));
}

TEST_F(PictureFile, Png_WithLinearGamma_IsReadAsLinear)
{
    const std::filesystem::path path = put("a.png", redAboveBluePng(100000));
    EXPECT_EQ(readPicture(path).format, PixelFormat::linear8);
    EXPECT_EQ(readPicture(path, Encoding::srgb).format, PixelFormat::srgb8);
    const std::filesystem::path usual = put("b.png", redAboveBluePng(45455));
    EXPECT_EQ(readPicture(usual).format, PixelFormat::srgb8);
    EXPECT_EQ(readPicture(usual, Encoding::linear).format, PixelFormat::linear8);
}

TEST_F(PictureFile, Png_Of16Bits_IsReadAsLinearFloats)
{
    const std::uint16_t grey = 32768;
    const std::filesystem::path path =
        put("a.png", pngBytes(1, 1, 16, SPNG_COLOR_TYPE_GRAYSCALE, 0, &grey, 2));
    const Picture curved = readPicture(path);
    ASSERT_EQ(curved.format, PixelFormat::float32);
    EXPECT_NEAR(curved.floats[0], 0.21404f, 1e-5f); // ((0.500008 + 0.055) / 1.055)^2.4
    EXPECT_EQ(curved.floats[2], curved.floats[0]);
    EXPECT_EQ(curved.floats[3], 1.0f);
    EXPECT_FLOAT_EQ(readPicture(path, Encoding::linear).floats[0], 32768.0f / 65535.0f);
}

TEST_F(PictureFile, Png_CutShortOrDamaged_IsRefused)
{
    std::vector<std::uint8_t> rgb(300);
    for (std::size_t i = 0; i < rgb.size(); ++i)
        rgb[i] = static_cast<std::uint8_t>(i * 37);
    std::string bytes = pngBytes(10, 10, 8, SPNG_COLOR_TYPE_TRUECOLOR, 0, rgb.data(), rgb.size());
    expectEveryCutRefused(folder_ / "cut.png", bytes,
                          4); // libspng does not read the checksum of the empty end chunk
    bytes[bytes.size() / 2] = static_cast<char>(bytes[bytes.size() / 2] ^ 1); // a checksum fails
    expectRefused(put("damaged.png", bytes), "broken or cut short");
}

TEST_F(PictureFile, Jpeg_NamedPng_IsToldByItsContent)
{
    const std::vector<std::uint8_t> grey(3 * 16 * 16, 128);
    std::string bytes;
    stbi_write_jpg_to_func(appendBytes, &bytes, 16, 16, 3, grey.data(), 90);
    const Picture picture = readPicture(put("a.png", bytes));
    EXPECT_EQ(picture.format, PixelFormat::srgb8);
    EXPECT_EQ(picture.width, 16);
    EXPECT_NEAR(picture.bytes[0], 128, 2); // lossy
    EXPECT_EQ(picture.bytes[3], 255);
    expectEveryCutRefused(folder_ / "cut.jpg", bytes);
}

TEST_F(PictureFile, Radiance_PackedRows_AreReadInFloatAndCutsRefused)
{
    Picture source = renderLikePicture(40, 5);
    source.floats[0] = 1000.0f;
    std::string bytes;
    stbi_write_hdr_to_func(appendBytes, &bytes, 40, 5, 4, source.floats.data());
    const Picture picture = readPicture(put("a.hdr", bytes));
    ASSERT_EQ(picture.format, PixelFormat::float32);
    const std::size_t topRow = 4 * 40 * 4;              // the writer's first row
    EXPECT_NEAR(picture.floats[topRow], 1000.0f, 4.0f); // 8 bits of mantissa
    EXPECT_NEAR(picture.floats[topRow + 4 * 20], source.floats[4 * 20], 0.004f);
    EXPECT_EQ(picture.floats[3], 1.0f);
    expectEveryCutRefused(folder_ / "cut.hdr", bytes); // stb's own reader hangs here
}

TEST_F(PictureFile, Radiance_FlatRowsWithRepeats_AreRead)
{
    const std::string header = "#?RADIANCE\n# a comment\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 4\n";
    const Picture picture =
        readPicture(put("a.hdr", header + std::string("\x80\x40\0\x81\x01\x01\x01\x03", 8)));
    for (std::size_t x = 0; x < 4; ++x) {
        EXPECT_EQ(picture.floats[4 * x], 1.0f); // 128 * 2^(129 - 136)
        EXPECT_EQ(picture.floats[4 * x + 1], 0.5f);
        EXPECT_EQ(picture.floats[4 * x + 2], 0.0f);
    }
    expectRefused(put("long.hdr", header + std::string("\x80\x40\0\x81\x01\x01\x01\x04", 8)),
                  "longer than its row");
}

TEST_F(PictureFile, Unknown_Empty_Missing_AreToldApart)
{
    expectRefused(put("a.png", "GIF89a and so on"), "not a picture of a known format");
    expectRefused(put("b.png", ""), "is empty");
    try {
        readPicture(folder_ / "absent.png");
        ADD_FAILURE();
    } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::inputMissing);
    }
}

TEST_F(PictureFile, AbsurdSize_IsRefusedBeforeMemoryIsTaken)
{
    expectRefused(put("a.hdr", "#?RADIANCE\n\n-Y 99999999 +X 99999999\n"), "too large (99999999x99999999");
    const std::vector<std::uint8_t> row(3 * 16385);
    expectRefused(put("a.png", pngBytes(16385, 1, 8, SPNG_COLOR_TYPE_TRUECOLOR, 0, row.data(), row.size())),
                  "too large");
}

} // namespace
} // namespace dioptre
