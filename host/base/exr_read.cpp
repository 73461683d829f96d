#include "base/error.h"
#include "base/exr_header.h"
#include "base/picture_codecs.h"
#include "base/text.h"

#include <fmt/format.h>

#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>

#include <algorithm>
#include <exception>

namespace dioptre
{
namespace
{

// The channels that go to R, G and B in this order, or the luminance channel that goes to all three.
std::vector<std::string> chooseChannels(const std::filesystem::path& path, const Imf::ChannelList& list)
{
    const auto has = [&](const char* name) {
        const Imf::Channel* channel = list.findChannel(name);
        if (channel != nullptr && (channel->xSampling != 1 || channel->ySampling != 1))
            fail(ExitCode::badInput, {path.string()},
                 fmt::format("its channel {} has fewer numbers than the picture has texels", name),
                 "save it without subsampling");
        return channel != nullptr;
    };
    if (has("R") || has("G") || has("B"))
        return {"R", "G", "B"};
    if (has("Y") && !has("RY") && !has("BY"))
        return {"Y"};
    std::vector<std::string> found;
    for (auto channel = list.begin(); channel != list.end(); ++channel)
        found.emplace_back(channel.name());
    fail(ExitCode::badInput, {path.string()}, fmt::format("its channels are {}", join(found, ", ")),
         "save it with the channels R, G, B or with Y alone");
}

long long length(int first, int last)
{
    return static_cast<long long>(last) - first + 1;
}

// The pixels of the data window, from the top down, whatever the file's types; missing alpha is 1, missing
// colour 0.
Picture readDataWindow(const std::filesystem::path& path, Imf::InputFile& file)
{
    const Imath::Box2i& window = file.header().dataWindow();
    const std::vector<std::string> channels = chooseChannels(path, file.header().channels());
    Picture data = blankPicture(path, length(window.min.x, window.max.x), length(window.min.y, window.max.y),
                                PixelFormat::float32);
    Imf::FrameBuffer frame;
    const auto insert = [&](const std::string& name, std::size_t slot, double missing) {
        frame.insert(name, Imf::Slice::Make(Imf::FLOAT, data.floats.data() + slot, window, 4 * sizeof(float),
                                            rowLength(data) * sizeof(float), 1, 1, missing));
    };
    for (std::size_t slot = 0; slot < channels.size(); ++slot)
        insert(channels[slot], slot, 0.0);
    insert("A", 3, 1.0);
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (channels.size() == 1)
        for (std::size_t i = 0; i < data.floats.size(); i += 4)
            data.floats[i + 1] = data.floats[i + 2] = data.floats[i];
    return data;
}

// The display window is the picture; where the data window does not reach it stays black and clear, and what
// lies outside is cropped.
Picture readDisplayWindow(const std::filesystem::path& path, const std::string& bytes)
{
    Imf::StdISStream stream;
    stream.str(bytes);
    checkExrHeaders(path, stream, bytes.size(), ExrReading::picture);
    Imf::InputFile file(stream);
    const Imath::Box2i display = file.header().displayWindow();
    const Imath::Box2i window = file.header().dataWindow();
    if (!file.isComplete())
        failBroken(path, "not all of its rows are there");
    Picture data = readDataWindow(path, file);
    if (window == display)
        return data;
    Picture picture = blankPicture(path, length(display.min.x, display.max.x),
                                   length(display.min.y, display.max.y), PixelFormat::float32);
    const int left = std::max(display.min.x, window.min.x), right = std::min(display.max.x, window.max.x);
    const int top = std::max(display.min.y, window.min.y), bottom = std::min(display.max.y, window.max.y);
    const auto at = [](const Picture& of, const Imath::Box2i& box, int x, int y) {
        return static_cast<std::ptrdiff_t>(rowLength(of)) * (y - box.min.y) +
               4 * std::ptrdiff_t{x - box.min.x};
    };
    for (int y = top; y <= bottom && left <= right; ++y)
        std::copy_n(data.floats.begin() + at(data, window, left, y), 4 * length(left, right),
                    picture.floats.begin() + at(picture, display, left, y));
    return picture;
}

} // namespace

Picture decodeExr(const std::filesystem::path& path, const std::string& bytes)
{
    try {
        Picture picture = readDisplayWindow(path, bytes);
        flipRows(picture);
        return picture;
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        failBroken(path, fault.what());
    }
}

} // namespace dioptre
