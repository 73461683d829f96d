#include "render/plain_channels.h"

#include "base/text.h"

#include <fmt/format.h>

#include <algorithm>

namespace dioptre
{
namespace
{

std::vector<std::string> cutAt(const std::string& text, char separator)
{
    std::vector<std::string> pieces;
    for (std::size_t begin = 0; begin <= text.size();) {
        const auto end = std::min(text.find(separator, begin), text.size());
        pieces.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return pieces;
}

// The choice whose word it is.
template <typename Choice>
bool read(const std::string& word, const std::vector<std::pair<std::string, Choice>>& choices, Choice& choice)
{
    const auto found = std::ranges::find_if(choices, [&](const auto& each) { return each.first == word; });
    if (found == choices.end())
        return false;
    choice = found->second;
    return true;
}

bool readSetting(const std::string& setting, ChannelSource& source)
{
    const auto pair = cutAt(setting, '=');
    if (setting == "cube")
        return source.cross = true;
    if (pair.size() != 2)
        return false;
    if (pair[0] == "filter")
        return read<TextureFilter>(pair[1],
                                   {{"nearest", TextureFilter::nearest},
                                    {"linear", TextureFilter::linear},
                                    {"mipmap", TextureFilter::mipmap}},
                                   source.filter);
    if (pair[0] == "wrap")
        return read<TextureWrap>(
            pair[1],
            {{"repeat", TextureWrap::repeat}, {"clamp", TextureWrap::clamp}, {"mirror", TextureWrap::mirror}},
            source.wrap.emplace());
    return pair[0] == "flip" && read<bool>(pair[1], {{"yes", true}, {"no", false}}, source.flip.emplace());
}

// Rows the other way round.
Picture flipped(const Picture& picture)
{
    Picture result = picture;
    const auto row = static_cast<std::ptrdiff_t>(4) * picture.width;
    const auto turn = [&](const auto& from, auto& to) {
        for (int y = 0; y < picture.height && !from.empty(); ++y)
            std::copy_n(from.begin() + y * row, row, to.begin() + (picture.height - 1 - y) * row);
    };
    turn(picture.bytes, result.bytes);
    turn(picture.floats, result.floats);
    return result;
}

// A square of a picture, rows as they stand.
Picture cut(const Picture& picture, int x, int y, int side)
{
    Picture result{side, side, picture.format, {}, {}};
    const auto take = [&](const auto& from, auto& to) {
        for (int row = 0; row < side && !from.empty(); ++row) {
            const auto begin = from.begin() + 4 * (static_cast<std::ptrdiff_t>(y + row) * picture.width + x);
            to.insert(to.end(), begin, begin + 4 * static_cast<std::ptrdiff_t>(side));
        }
    };
    take(picture.bytes, result.bytes);
    take(picture.floats, result.floats);
    return result;
}

// +x -x +y -y +z -z of an upright picture, rows from the top down, of 4x3 squares (+y above and -y below the
// second of -x +z +x -z) or of 3x4 (-z below -y, upside down).
std::vector<Picture> facesOf(const Picture& cross, const std::string& file)
{
    const bool wide = 3 * cross.width == 4 * cross.height;
    const bool tall = 4 * cross.width == 3 * cross.height;
    if (!wide && !tall)
        fail(ExitCode::badInput, {file},
             fmt::format("{}x{} is no cross of a cube's faces", cross.width, cross.height),
             "give 4 by 3 squares, 3 by 4, or six files");
    const int side = wide ? cross.width / 4 : cross.width / 3;
    const auto square = [&](int column, int row) { return cut(cross, column * side, row * side, side); };
    std::vector<Picture> faces = {square(2, 1), square(0, 1), square(1, 0), square(1, 2), square(1, 1)};
    if (wide) {
        faces.push_back(square(3, 1));
        return faces;
    }
    Picture turned = flipped(square(1, 3));
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side / 2; ++x)
            for (std::size_t c = 0; c < 4; ++c) {
                const auto at = [&](int column) {
                    return 4 * static_cast<std::size_t>(y * side + column) + c;
                };
                if (!turned.bytes.empty())
                    std::swap(turned.bytes[at(x)], turned.bytes[at(side - 1 - x)]);
                else
                    std::swap(turned.floats[at(x)], turned.floats[at(side - 1 - x)]);
            }
    faces.push_back(std::move(turned));
    return faces;
}

// The loader gives the lowest row first, and t = 0 is the top of a face: OpenGL 3.3, table 3.19, looks at
// faces from within and with t downwards.
ChannelPictures loadCube(const ChannelSource& source)
{
    std::vector<Picture> faces;
    if (source.cross)
        faces = facesOf(flipped(readPicture(source.files.front(), Encoding::linear)), source.files.front());
    else
        for (const auto& file : source.files)
            faces.push_back(flipped(readPicture(file, Encoding::linear)));
    if (source.flip.value_or(false))
        std::ranges::transform(faces, faces.begin(), flipped);
    for (std::size_t i = 0; i < faces.size(); ++i)
        if (faces[i].width != faces[i].height || faces[i].width != faces.front().width ||
            faces[i].format != faces.front().format)
            fail(ExitCode::badInput, {source.files[source.cross ? 0 : i]},
                 fmt::format("a cube's faces are squares of one size and kind, and this is {}x{}",
                             faces[i].width, faces[i].height),
                 "give six such pictures");
    const int side = faces.front().width;
    const TextureShape shape = shapeOfCube(faces, source.filter);
    return {std::move(faces), shape, {side, side}};
}

} // namespace

ChannelSource channelSource(const std::string& option, std::size_t channel)
{
    ChannelSource source;
    if (option.empty())
        return source;
    const auto mark = std::min(option.rfind('?'), option.size());
    source.files = cutAt(option.substr(0, mark), ',');
    bool good = source.files.size() == 1 || source.files.size() == 6;
    if (mark < option.size())
        for (const auto& setting : cutAt(option.substr(mark + 1), '&'))
            good = good && readSetting(setting, source);
    if (!good || (source.cross && source.files.size() != 1))
        fail(ExitCode::usage, fmt::format("--channel{} {} cannot be read", channel, option),
             "write FILE, or six FILE,FILE,… for a cube, then, if wanted, "
             "?filter=nearest|linear|mipmap&wrap=repeat|clamp|mirror&flip=yes|no, and &cube for a cross");
    if (source.wrap && source.kind() == ChannelKind::cube)
        fail(ExitCode::usage, fmt::format("--channel{} {} wraps a cube, which has no ends", channel, option),
             "leave wrap out");
    return source;
}

ChannelPictures loadChannel(const ChannelSource& source)
{
    if (source.files.empty()) {
        const Picture black{1, 1, PixelFormat::linear8, {0, 0, 0, 255}, {}};
        return {{black}, shapeOfPicture(black, TextureFilter::nearest, TextureWrap::repeat), {0, 0}};
    }
    if (source.kind() == ChannelKind::cube)
        return loadCube(source);
    // The loader gives the lowest row first.
    Picture picture = readPicture(source.files.front(), Encoding::linear);
    if (!source.flip.value_or(true))
        picture = flipped(picture);
    const glm::ivec2 size(picture.width, picture.height);
    const TextureShape shape =
        shapeOfPicture(picture, source.filter, source.wrap.value_or(TextureWrap::repeat));
    return {{std::move(picture)}, shape, size};
}

Channel uploadChannel(const ChannelPictures& channel)
{
    const bool cube = channel.shape.target == GL_TEXTURE_CUBE_MAP;
    return {cube ? uploadCube(channel.pictures, channel.shape)
                 : uploadPicture(channel.pictures.front(), channel.shape),
            channel.shape.target, channel.size_px};
}

} // namespace dioptre
