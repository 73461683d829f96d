#include "base/exr_encoder.h"
#include "base/picture_writer.h"

#include <half.h>

#include <algorithm>
#include <cstddef>

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

// Numbers that stand `stride` apart as a channel of the rows in `window`.
template <typename Number>
Imf::Slice sliceOf(Imf::PixelType type, const Number* first, const Imath::Box2i& window, std::size_t stride)
{
    const auto width = static_cast<std::size_t>(window.max.x - window.min.x + 1);
    return Imf::Slice::Make(type, first, window, stride * sizeof(Number), stride * sizeof(Number) * width);
}

ExrHead headOf(int width, int height, Imf::PixelType type, const std::vector<std::string>& layerChannels)
{
    ExrHead head{width, height, {{"R", type}, {"G", type}, {"B", type}}};
    for (const auto& channel : layerChannels)
        head.channels[channel] = Imf::FLOAT;
    return head;
}

template <typename Number>
class ExrWriter : public PictureWriter
{
public:
    ExrWriter(const std::filesystem::path& path, int width, int height, const Settings& settings,
              const std::vector<std::string>& layerChannels)
        : encoder_(path, headOf(width, height, type, layerChannels), settings)
    {
    }

    void add(const Picture& band, const std::vector<ExrLayer>& layers) override
    {
        const std::vector<Number> numbers = topDownRgb<Number>(band);
        std::vector<std::vector<float>> planes;
        for (const ExrLayer& layer : layers)
            planes.push_back(topDown(layer, static_cast<std::size_t>(band.width)));
        encoder_.add(band.height, [&](const Imath::Box2i& window) {
            Imf::FrameBuffer frame;
            std::size_t slot = 0;
            for (const char* name : {"R", "G", "B"})
                frame.insert(name, sliceOf(type, numbers.data() + slot++, window, 3));
            for (std::size_t i = 0; i < layers.size(); ++i)
                frame.insert(layers[i].channel, sliceOf(Imf::FLOAT, planes[i].data(), window, 1));
            return frame;
        });
    }

    void finish() override
    {
        encoder_.finish();
    }

private:
    static constexpr Imf::PixelType type = std::is_same_v<Number, Imath::half> ? Imf::HALF : Imf::FLOAT;

    ExrEncoder encoder_;
};

} // namespace

std::unique_ptr<PictureWriter> openExr(const std::filesystem::path& path, int width, int height,
                                       ExrDepth depth, const Settings& settings,
                                       const std::vector<std::string>& layerChannels)
{
    if (depth == ExrDepth::half)
        return std::make_unique<ExrWriter<Imath::half>>(path, width, height, settings, layerChannels);
    return std::make_unique<ExrWriter<float>>(path, width, height, settings, layerChannels);
}

void writeExr(const std::filesystem::path& path, const Picture& picture, ExrDepth depth,
              const Settings& settings, const std::vector<ExrLayer>& layers)
{
    std::vector<std::string> channels;
    for (const ExrLayer& layer : layers)
        channels.push_back(layer.channel);
    const auto writer = openExr(path, picture.width, picture.height, depth, settings, channels);
    writer->add(picture, layers);
    writer->finish();
}

} // namespace dioptre
