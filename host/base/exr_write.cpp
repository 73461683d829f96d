#include "base/error.h"
#include "base/picture.h"
#include "base/write_file.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfStdIO.h>
#include <ImfStringAttribute.h>

#include <algorithm>
#include <cstddef>
#include <exception>

namespace dioptre
{
namespace
{

// R, G, B of each texel, from the top down. A number beyond the largest half becomes that half: an infinity
// would spoil every filter and mean that is taken later.
template <typename Number>
std::vector<Number> topDownRgb(const Picture& picture)
{
    std::vector<Number> numbers;
    const auto width = static_cast<std::size_t>(picture.width),
               height = static_cast<std::size_t>(picture.height);
    numbers.reserve(3 * width * height);
    for (std::size_t row = height; row-- > 0;)
        for (std::size_t x = 0; x < width; ++x)
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const float value = picture.floats[4 * (row * width + x) + channel];
                if constexpr (std::is_same_v<Number, Imath::half>)
                    numbers.push_back(Imath::half(std::clamp(value, -float{HALF_MAX}, float{HALF_MAX})));
                else
                    numbers.push_back(value);
            }
    return numbers;
}

// The rows of a layer from the top down.
std::vector<float> topDown(const ExrLayer& layer, std::size_t width)
{
    std::vector<float> numbers;
    numbers.reserve(layer.numbers.size());
    for (auto row = layer.numbers.end(); row != layer.numbers.begin();) {
        row -= static_cast<std::ptrdiff_t>(width);
        numbers.insert(numbers.end(), row, row + static_cast<std::ptrdiff_t>(width));
    }
    return numbers;
}

// Numbers that stand `stride` apart as a channel of the file.
template <typename Number>
void insertChannel(Imf::Header& header, Imf::FrameBuffer& frame, const std::string& name, Imf::PixelType type,
                   const Number* first, std::size_t stride)
{
    header.channels().insert(name, Imf::Channel(type));
    frame.insert(name, Imf::Slice::Make(type, first, header.dataWindow(), stride * sizeof(Number),
                                        stride * sizeof(Number) *
                                            static_cast<std::size_t>(header.dataWindow().max.x + 1)));
}

template <typename Number>
std::string encode(const Picture& picture, Imf::PixelType type, const Settings& settings,
                   const std::vector<ExrLayer>& layers)
{
    Imf::Header header(picture.width, picture.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : settings)
        header.insert(key, Imf::StringAttribute(value));
    const std::vector<Number> numbers = topDownRgb<Number>(picture);
    Imf::FrameBuffer frame;
    std::size_t slot = 0;
    for (const char* name : {"R", "G", "B"})
        insertChannel(header, frame, name, type, numbers.data() + slot++, 3);
    std::vector<std::vector<float>> planes;
    for (const ExrLayer& layer : layers) {
        planes.push_back(topDown(layer, static_cast<std::size_t>(picture.width)));
        insertChannel(header, frame, layer.channel, Imf::FLOAT, planes.back().data(), 1);
    }
    Imf::StdOSStream stream;
    {
        Imf::OutputFile file(stream, header); // its destructor writes the table of lines
        file.setFrameBuffer(frame);
        file.writePixels(picture.height);
    }
    return stream.str();
}

} // namespace

// Encoded in memory first, so that a full disk is noticed by writeFile: OpenEXR's destructor would keep
// silent about it.
void writeExr(const std::filesystem::path& path, const Picture& picture, ExrDepth depth,
              const Settings& settings, const std::vector<ExrLayer>& layers)
{
    std::string bytes;
    try {
        bytes = depth == ExrDepth::half ? encode<Imath::half>(picture, Imf::HALF, settings, layers)
                                        : encode<float>(picture, Imf::FLOAT, settings, layers);
    } catch (const std::exception& fault) {
        fail(ExitCode::cannotWrite, {path.string()}, fault.what(), "write a PNG in its place");
    }
    writeFile(path, bytes);
}

} // namespace dioptre
