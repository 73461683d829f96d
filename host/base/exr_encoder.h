// The file of an EXR, band by band.
#pragma once

#include "base/checked_file.h"
#include "base/picture.h"

#include <ImfFrameBuffer.h>
#include <ImfIO.h>
#include <ImfOutputFile.h>
#include <ImfPixelType.h>

#include <functional>
#include <memory>

namespace dioptre
{

// OpenEXR's view of a file of ours; faults stay in the file, which is asked for them.
class ExrStream : public Imf::OStream
{
public:
    ExrStream(const std::filesystem::path& path, CheckedFile& file);
    void write(const char bytes[], int count) override;
    std::uint64_t tellp() override;
    void seekp(std::uint64_t position) override;

private:
    CheckedFile& file_;
};

// What the head of a file says, beside its settings.
struct ExrHead {
    int width = 0;  // pixels
    int height = 0; // pixels
    std::map<std::string, Imf::PixelType> channels{};
};

class ExrEncoder
{
public:
    ExrEncoder(const std::filesystem::path& path, const ExrHead& head, const Settings& settings);

    // The next `rows` below. `frameOf` is given their place in the picture, which its slices are to be made
    // for. Throws cannotWrite.
    void add(int rows, const std::function<Imf::FrameBuffer(const Imath::Box2i&)>& frameOf);

    // After the last row. Throws cannotWrite.
    void finish();

private:
    std::filesystem::path path_;
    CheckedFile file_;
    ExrStream stream_;
    int width_;
    int done_ = 0;                            // rows
    std::unique_ptr<Imf::OutputFile> output_; // last: it ends by writing to the stream
};

} // namespace dioptre
