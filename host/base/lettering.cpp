#include "base/lettering.h"

#include "base/error.h"
#include "base/utf8.h"

#include <fmt/format.h>

#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <algorithm>
#include <utility>
#include <vector>

namespace dioptre
{
namespace
{

constexpr const char* ellipsis = "…";

void checkFont(FT_Error fault, const std::filesystem::path& path)
{
    if (fault != 0)
        fail(ExitCode::badInput, {path.string()},
             fmt::format("is no font to draw with (FreeType: {})", fault),
             "install the package fonts-dejavu-core again");
}

// FreeType's places are in 64ths of a pixel.
int pixelsDown(FT_Pos place)
{
    return static_cast<int>(place >> 6);
}

int pixelsUp(FT_Pos place)
{
    return pixelsDown(place + 63);
}

// Loads each letter's outline in turn, moved to where it begins within its pixel, and calls
// visit(slot, the column of that pixel). The first letter begins at `pen`; gives where the last one ends.
template <typename Visit>
FT_Pos eachLetter(FT_Face face, const std::filesystem::path& path, std::string_view text, FT_Pos pen,
                  Visit visit)
{
    for (std::size_t at = 0; at < text.size();) {
        const char32_t code = nextCodePoint(text, at);
        const FT_UInt glyph = FT_Get_Char_Index(face, code < 0x20 || code == 0x7F ? U' ' : code);
        // Hinted upright only: the horizontal strokes are crisp, and letters keep their shapes and distances.
        checkFont(FT_Load_Glyph(face, glyph, FT_LOAD_NO_BITMAP | FT_LOAD_TARGET_LIGHT), path);
        FT_GlyphSlot slot = face->glyph;
        FT_Outline_Translate(&slot->outline, pen & 63, 0);
        visit(slot, pixelsDown(pen));
        pen += slot->linearHoriAdvance >> 10; // from 16.16: not rounded to pixels
    }
    return pen;
}

// Columns that a text touches or ends within when its first letter begins at column 0.
struct TextExtent {
    int left = 0;  // 0, or less where the first letter reaches out
    int right = 0; // the first column beyond
};

TextExtent extentOf(FT_Face face, const std::filesystem::path& path, std::string_view text)
{
    TextExtent extent;
    const FT_Pos end = eachLetter(face, path, text, 0, [&](FT_GlyphSlot slot, int column) {
        FT_BBox box;
        FT_Outline_Get_CBox(&slot->outline, &box);
        extent.left = std::min(extent.left, column + pixelsDown(box.xMin));
        extent.right = std::max(extent.right, column + pixelsUp(box.xMax));
    });
    extent.right = std::max(extent.right, pixelsUp(end));
    return extent;
}

// A letter's bitmap, its upper left pixel at x, top.
void drawLetter(Picture& picture, const FT_Bitmap& bitmap, int x, int top, Colour8 colour)
{
    const int width = static_cast<int>(bitmap.width), height = static_cast<int>(bitmap.rows);
    const PixelRectangle seen =
        common({x, top - height + 1, width, height}, {0, 0, picture.width, picture.height});
    for (int row = seen.y; row < seen.y + seen.height; ++row) {
        const unsigned char* coverage = bitmap.buffer + static_cast<std::ptrdiff_t>(top - row) * bitmap.pitch;
        for (int column = seen.x; column < seen.x + seen.width; ++column)
            if (const unsigned char covered = coverage[column - x]; covered != 0)
                blendPixel(picture, column, row, colour, static_cast<float>(covered) / 255.0f);
    }
}

} // namespace

std::filesystem::path usualFont()
{
    return DIOPTRE_FONT;
}

int legibleSize(int pictureWidth)
{
    return std::clamp(pictureWidth / 22, 11, 28);
}

void Lettering::End::operator()(FT_LibraryRec_* library) const
{
    FT_Done_FreeType(library);
}

void Lettering::End::operator()(FT_FaceRec_* face) const
{
    FT_Done_Face(face);
}

Lettering::Lettering(int size_px, const std::filesystem::path& font) : path_(font)
{
    FT_Library library = nullptr;
    checkFont(FT_Init_FreeType(&library), font);
    library_.reset(library);
    FT_Face face = nullptr;
    const FT_Error fault = FT_New_Face(library, font.c_str(), 0, &face);
    if (fault == FT_Err_Cannot_Open_Resource)
        fail(ExitCode::inputMissing, {font.string()}, "the font that labels are drawn with cannot be opened",
             "install the package fonts-dejavu-core");
    checkFont(fault, font);
    face_.reset(face);
    if (!FT_IS_SCALABLE(face))
        checkFont(FT_Err_Invalid_File_Format, font);
    checkFont(FT_Set_Pixel_Sizes(face, 0, static_cast<FT_UInt>(size_px)), font);
}

int Lettering::ascent() const
{
    return pixelsUp(face_->size->metrics.ascender);
}

int Lettering::descent() const
{
    return pixelsUp(-face_->size->metrics.descender);
}

int Lettering::lineHeight() const
{
    return ascent() + descent();
}

int Lettering::width(std::string_view text) const
{
    const TextExtent extent = extentOf(face_.get(), path_, text);
    return extent.right - extent.left;
}

std::string Lettering::shortened(std::string_view text, int width_px) const
{
    if (width(text) <= width_px)
        return std::string(text);
    std::vector<std::size_t>
        cuts; // bytes before which the text may end: behind its first letter at the earliest
    for (std::size_t at = 0; at < text.size();) {
        nextCodePoint(text, at);
        cuts.push_back(at);
    }
    const auto cutAt = [&](std::size_t byte) { return std::string(text.substr(0, byte)) + ellipsis; };
    const auto tooWide = std::partition_point(
        cuts.begin(), cuts.end(), [&](std::size_t byte) { return width(cutAt(byte)) <= width_px; });
    return tooWide == cuts.begin() ? "" : cutAt(*std::prev(tooWide));
}

void Lettering::draw(Picture& picture, std::string_view text, int x, int baseline, Colour8 colour) const
{
    x -= extentOf(face_.get(), path_, text).left;
    eachLetter(face_.get(), path_, text, 0, [&](FT_GlyphSlot slot, int column) {
        checkFont(FT_Render_Glyph(slot, FT_RENDER_MODE_NORMAL), path_);
        drawLetter(picture, slot->bitmap, x + column + slot->bitmap_left, baseline + slot->bitmap_top - 1,
                   colour);
    });
}

} // namespace dioptre
