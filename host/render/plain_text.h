// A plain shader's text, made into a whole program's: its own main() as it stands, or Shadertoy's mainImage()
// with what that site puts around it. The author's lines stay unchanged.
#pragma once

#include "base/search_places.h"
#include "render/source_text.h"

#include <array>
#include <cstdint>
#include <filesystem>

namespace dioptre
{

enum class ChannelKind { picture, cube };

// What is written around a plain shader.
struct PlainForm {
    std::array<ChannelKind, 4> channels{};
    bool inTiles = false;         // what is drawn at once is less than the picture
    bool loopsMayBeEnded = false; // by the driver, without a word: pixels are to tell
};

// Of the tile's lower left corner, in the whole picture.
inline constexpr const char* tileOriginUniform = "dioptre_tile_origin_px";

// The bits that stand for alpha where a pixel's loops were ended: a NaN that no arithmetic makes.
inline constexpr std::uint32_t loopsWereEnded = 0x7FC0D109U;

// Always 2: the check of loops reads it, so that no compiler knows. One that drops it knows that the check is
// never reached.
inline constexpr const char* loopCheckUniform = "dioptre_two";

struct PlainText {
    SourceText text;
    bool mainImage = false;   // Shadertoy's convention
    bool discards = false;    // it mentions discard
    bool checksLoops = false; // a pixel whose loops were ended holds `loopsWereEnded` in one of its channels
};

// Where the names of a plain shader's includes lead: beside it, to the folders of --include, to glsl/.
Search includeSearch(const std::filesystem::path& shader, const SearchPlaces& places);

// Throws badInput (includes in a circle or out of those folders, a #version that is neither 330 core nor 300
// es, neither main() nor mainImage(), a gl_FragCoord declared anew in tiles) and inputMissing.
PlainText assemblePlain(const std::filesystem::path& shader, const SearchPlaces& places,
                        const PlainForm& form);

} // namespace dioptre
