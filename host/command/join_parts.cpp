#include "command/join_parts.h"

#include "base/error.h"
#include "base/text.h"
#include "base/tile_rows.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

constexpr std::string_view tileKey = "dioptre.tile";
constexpr std::string_view hashKey = "dioptre.hash";

struct TilePart {
    std::string path;
    StoredHead head;
    Settings settings;
    int tile = 0; // from 1, the top one
    int tiles = 0;
    int width = 0;  // of the whole picture, pixels
    int height = 0; // of the whole picture, pixels
};

std::string valueOf(const Settings& settings, std::string_view key)
{
    const auto found = settings.find(std::string(key));
    return found == settings.end() ? "" : found->second;
}

TilePart readPart(const std::string& path)
{
    TilePart part{path, readStoredHead(path), readSettings(path)};
    const std::string tile = valueOf(part.settings, tileKey), size = valueOf(part.settings, "dioptre.size"),
                      hash = valueOf(part.settings, hashKey);
    if (tile.empty() || size.empty() || hash.empty())
        fail(ExitCode::badInput, {path}, "does not say which tile of which picture it is",
             "name pictures that dioptre render --tile wrote");
    if (!readPair(tile, '/', part.tile, part.tiles) || part.tile > part.tiles ||
        !readPair(size, 'x', part.width, part.height) || part.tiles > mostTiles(part.height))
        fail(ExitCode::badInput, {path}, fmt::format("its text says tile {} of a {} picture", tile, size),
             "draw it again");
    return part;
}

[[noreturn]] void failUnlike(const TilePart& part, const TilePart& first, std::string_view what)
{
    fail(ExitCode::badInput, {part.path}, fmt::format("{} than {}", what, first.path),
         "join the tiles of one picture, drawn with the same options");
}

// The first key, by name, that the two do not hold alike; "" where there is none.
std::string firstDifference(const Settings& some, const Settings& others)
{
    Settings all = some;
    all.insert(others.begin(), others.end());
    for (const auto& [key, value] : all)
        if (key != tileKey && key != hashKey && valueOf(some, key) != valueOf(others, key))
            return key;
    return "";
}

std::string shown(const std::string& value)
{
    return value.empty() ? "nothing" : "'" + value + "'";
}

void refuseUnlike(const TilePart& part, const TilePart& first)
{
    if (part.head.kind != first.head.kind)
        failUnlike(
            part, first,
            fmt::format("is {}, another kind of file ({})", nameOf(part.head.kind), nameOf(first.head.kind)));
    const std::string key = firstDifference(part.settings, first.settings);
    if (!key.empty())
        fail(ExitCode::badInput, {part.path},
             fmt::format("its {} is {}, and {} of {}", key, shown(valueOf(part.settings, key)),
                         shown(valueOf(first.settings, key)), first.path),
             "join the tiles of one picture, drawn with the same options");
    if (part.head.form != first.head.form)
        fail(ExitCode::badInput, {part.path},
             fmt::format("holds {}, and {} holds {}", part.head.form, first.path, first.head.form),
             "join the tiles of one picture, drawn with the same options");
    if (part.tiles != first.tiles)
        fail(ExitCode::badInput, {part.path},
             fmt::format("is tile {} of {}, and {} is one of {}", part.tile, part.tiles, first.path,
                         first.tiles),
             "join the tiles of one run");
    if (valueOf(part.settings, hashKey) != valueOf(first.settings, hashKey))
        failUnlike(part, first,
                   "was drawn from another scene, other shaders or pictures, or with other options");
}

void refuseWrongSize(const TilePart& part)
{
    const int rows = tileRows(part.height, part.tile, part.tiles).count;
    if (part.head.width != part.width || part.head.height != rows)
        fail(ExitCode::badInput, {part.path},
             fmt::format("is {}x{}, and tile {} of {} of a {}x{} picture is {}x{}", part.head.width,
                         part.head.height, part.tile, part.tiles, part.width, part.height, part.width, rows),
             "draw it again");
}

// By tile, from the first; all are of one picture.
void refuseGaps(const std::vector<TilePart>& parts)
{
    for (std::size_t i = 1; i < parts.size(); ++i)
        if (parts[i].tile == parts[i - 1].tile)
            fail(ExitCode::badInput, {parts[i].path},
                 fmt::format("is tile {} of {}, as {} is", parts[i].tile, parts[i].tiles, parts[i - 1].path),
                 "name each tile once");
    std::vector<std::string> missing;
    auto part = parts.begin();
    for (int tile = 1; tile <= parts.front().tiles; ++tile) {
        if (part != parts.end() && part->tile == tile)
            ++part;
        else
            missing.push_back(std::to_string(tile));
    }
    if (!missing.empty())
        fail(ExitCode::badInput,
             fmt::format("of {} tiles {} {} missing", parts.front().tiles, join(missing, ", "),
                         missing.size() == 1 ? "is" : "are"),
             "draw them with --tile, and name all");
}

} // namespace

std::string_view nameOf(StoredKind kind)
{
    switch (kind) {
    case StoredKind::png:
        return "PNG";
    case StoredKind::radiance:
        return "Radiance HDR";
    case StoredKind::exr:
        return "EXR";
    }
    return "";
}

TiledPicture tiledPicture(const std::vector<std::string>& paths)
{
    std::vector<TilePart> parts;
    for (const auto& path : paths) {
        parts.push_back(readPart(path));
        refuseUnlike(parts.back(), parts.front());
        refuseWrongSize(parts.back());
    }
    std::ranges::stable_sort(parts, {}, &TilePart::tile);
    refuseGaps(parts);
    const TilePart& first = parts.front();
    TiledPicture picture{first.head.kind, first.width, first.height, {}, first.settings};
    for (const TilePart& part : parts)
        picture.topDown.push_back(part.path);
    picture.settings.erase(std::string(tileKey));
    picture.settings.erase(std::string(hashKey));
    return picture;
}

} // namespace dioptre
