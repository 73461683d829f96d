#include "base/error.h"
#include "base/exr_encoder.h"
#include "base/exr_header.h"
#include "base/picture_codecs.h"
#include "base/stack_kinds.h"

#include <ImfChannelList.h>
#include <ImfHeader.h>

#include <algorithm>
#include <climits>
#include <exception>
#include <memory>

namespace dioptre
{
namespace
{

// What OpenEXR throws while it reads becomes an Error of ours.
template <typename Action>
auto reading(const std::filesystem::path& path, Action action)
{
    try {
        return action();
    } catch (const Error&) {
        throw;
    } catch (const std::exception& fault) {
        failBroken(path, fault.what());
    }
}

[[noreturn]] void failForeign(const std::filesystem::path& path)
{
    fail(ExitCode::badInput, {path.string()}, "is an EXR in another form than dioptre writes",
         "name the file as it was written");
}

ExrHead headOf(const std::filesystem::path& path, const Imf::Header& header)
{
    const Imath::Box2i window = header.dataWindow();
    if (window != header.displayWindow() || window.min != Imath::V2i(0, 0) || window.max.x == INT_MAX ||
        window.max.y == INT_MAX || header.hasTileDescription())
        failForeign(path);
    ExrHead head{window.max.x + 1, window.max.y + 1, {}};
    for (auto channel = header.channels().begin(); channel != header.channels().end(); ++channel) {
        const Imf::Channel& form = channel.channel();
        if (form.xSampling != 1 || form.ySampling != 1 || form.type == Imf::UINT)
            failForeign(path);
        head.channels[channel.name()] = form.type;
    }
    return head;
}

// A few rows of all channels, each in its own type.
class ExrRows
{
public:
    ExrRows(const ExrHead& head, int rows) : head_(head)
    {
        for (const auto& [name, type] : head.channels)
            planes_[name].resize(static_cast<std::size_t>(rows) * rowBytes(type));
    }

    // To be read or written as the rows of that window.
    Imf::FrameBuffer frame(const Imath::Box2i& window)
    {
        Imf::FrameBuffer frame;
        for (const auto& [name, type] : head_.channels)
            frame.insert(name, Imf::Slice::Make(type, planes_[name].data(), window, numberBytes(type),
                                                rowBytes(type)));
        return frame;
    }

private:
    static std::size_t numberBytes(Imf::PixelType type)
    {
        return type == Imf::HALF ? 2 : 4;
    }

    std::size_t rowBytes(Imf::PixelType type) const
    {
        return static_cast<std::size_t>(head_.width) * numberBytes(type);
    }

    const ExrHead& head_;
    std::map<std::string, std::vector<char>> planes_;
};

} // namespace

StoredHead readExrHead(const std::filesystem::path& path)
{
    const ExrHead head = reading(path, [&] { return headOf(path, ExrInput(path).file.header()); });
    std::string form = "channels";
    for (const auto& [name, type] : head.channels)
        form += " " + name + (type == Imf::HALF ? ":16" : ":32");
    return {StoredKind::exr, head.width, head.height, form};
}

void stackExrs(const PictureStack& stack, const std::filesystem::path& output, const RowsDone& rowsDone)
{
    const auto& first = stack.topDown.front();
    ExrHead head = reading(first, [&] { return headOf(first, ExrInput(first).file.header()); });
    head.height = stack.height;
    ExrEncoder encoder(output, head, stack.settings);
    ExrRows rows(head, rowsBetweenReports);
    int done = 0;
    for (const auto& path : stack.topDown) {
        const auto input = reading(path, [&] { return std::make_unique<ExrInput>(path); });
        Imf::InputFile& file = input->file;
        const int height = file.header().dataWindow().max.y + 1;
        for (int y = 0; y < height; y += rowsBetweenReports) {
            const int last = std::min(height, y + rowsBetweenReports) - 1;
            reading(path, [&] {
                file.setFrameBuffer(rows.frame({{0, y}, {head.width - 1, last}}));
                file.readPixels(y, last);
            });
            encoder.add(last - y + 1, [&](const Imath::Box2i& window) { return rows.frame(window); });
            done += last - y + 1;
            rowsDone(done);
        }
    }
    encoder.finish();
}

} // namespace dioptre
