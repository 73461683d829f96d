#include "base/exr_encoder.h"

#include "base/error.h"

#include <ImfChannelList.h>
#include <ImfCompression.h>
#include <ImfHeader.h>
#include <ImfStringAttribute.h>

#include <exception>

namespace dioptre
{
namespace
{

Imf::Header headerOf(const ExrHead& head, const Settings& settings)
{
    Imf::Header header(head.width, head.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    for (const auto& [key, value] : settings)
        header.insert(key, Imf::StringAttribute(value));
    for (const auto& [name, type] : head.channels)
        header.channels().insert(name, Imf::Channel(type));
    return header;
}

// What OpenEXR throws becomes an Error of ours.
template <typename Action>
void guarded(const std::filesystem::path& path, Action action)
{
    try {
        action();
    } catch (const std::exception& fault) {
        fail(ExitCode::cannotWrite, {path.string()}, fault.what(), "write a PNG in its place");
    }
}

} // namespace

ExrStream::ExrStream(const std::filesystem::path& path, CheckedFile& file)
    : OStream(path.c_str()), file_(file)
{
}

void ExrStream::write(const char bytes[], int count)
{
    file_.write(bytes, static_cast<std::size_t>(count));
}

std::uint64_t ExrStream::tellp()
{
    return file_.position();
}

void ExrStream::seekp(std::uint64_t position)
{
    file_.moveTo(position);
}

ExrEncoder::ExrEncoder(const std::filesystem::path& path, const ExrHead& head, const Settings& settings)
    : path_(path), file_(path), stream_(path, file_), width_(head.width)
{
    guarded(path_, [&] { output_ = std::make_unique<Imf::OutputFile>(stream_, headerOf(head, settings)); });
}

void ExrEncoder::add(int rows, const std::function<Imf::FrameBuffer(const Imath::Box2i&)>& frameOf)
{
    guarded(path_, [&] {
        output_->setFrameBuffer(frameOf({{0, done_}, {width_ - 1, done_ + rows - 1}}));
        output_->writePixels(rows);
    });
    done_ += rows;
    file_.check();
}

// OpenEXR's destructor writes the table of lines and keeps silent about faults.
void ExrEncoder::finish()
{
    output_.reset();
    file_.finish();
}

} // namespace dioptre
