// Text drawn into pictures of 8 bits.
#pragma once

#include "base/canvas.h"

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

struct FT_LibraryRec_;
struct FT_FaceRec_;

namespace dioptre
{

// The file of DejaVu Sans, as it was found when the program was built.
std::filesystem::path usualFont();

// Pixels of an em that are legible in a picture so many pixels wide: 1/22 of it, from 11 to 28.
int legibleSize(int pictureWidth);

// A font in one size. Text is UTF-8 on one line, from left to right, a letter after the other without
// kerning: scripts whose letters join show them apart. Control characters are drawn as spaces; what the font
// does not have, and bytes that are no UTF-8, as its sign for that. One thread at a time.
class Lettering
{
public:
    // `size_px` of an em, 1 to 1000: capitals are some 0.73 of it high. Throws inputMissing where the font's
    // file is missing, badInput where it is no outline font.
    explicit Lettering(int size_px, const std::filesystem::path& font = usualFont());
    Lettering(Lettering&&) = default;
    Lettering& operator=(Lettering&&) = delete; // member by member a library would end before its font

    int ascent() const;     // pixels from the baseline up; capitals with accents reach a little higher
    int descent() const;    // pixels from the baseline down
    int lineHeight() const; // pixels: both

    // Pixels from the first that the text may touch to the last, spaces at its ends included.
    int width(std::string_view text) const;

    // The text where it is at most `width_px` wide; otherwise as much of its beginning as leaves place for an
    // ellipsis, and "" where not even one letter has place before that.
    std::string shortened(std::string_view text, int width_px) const;

    // Draws into an srgb8 picture: into the columns from x to x + width(text) - 1 and the rows from
    // baseline - descent() to baseline + ascent() - 1 (see there), those of them that the picture has. Edges
    // are mixed in linear light, as what covers a part of a pixel sends a part of its light.
    void draw(Picture& picture, std::string_view text, int x, int baseline, Colour8 colour) const;

private:
    struct End {
        void operator()(FT_LibraryRec_* library) const;
        void operator()(FT_FaceRec_* face) const;
    };
    std::filesystem::path path_;
    std::unique_ptr<FT_LibraryRec_, End> library_;
    std::unique_ptr<FT_FaceRec_, End> face_; // ends before its library
};

} // namespace dioptre
