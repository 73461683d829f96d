// Pictures whose files are written band by band, from the top down, so that the whole is never in memory.
#pragma once

#include "base/picture.h"

#include <memory>

namespace dioptre
{

// A picture's file that is written band by band. The bytes are the same whatever the bands.
class PictureWriter
{
public:
    virtual ~PictureWriter() = default;

    // The next rows below those that are there: all rows of `band`, a picture as wide as the whole, whose row
    // 0 is its lowest. `layers`: one for each channel named at the opening, with the band's numbers. Throws
    // cannotWrite.
    virtual void add(const Picture& band, const std::vector<ExrLayer>& layers = {}) = 0;

    // After the last row: ends the file and gives it its name; nothing is there before. Throws cannotWrite.
    virtual void finish() = 0;
};

// Sizes are of the whole picture, in pixels. They write what writePng(), writeRadiance() and writeExr() do;
// Radiance and EXR take float32 bands. Throw cannotWrite.
std::unique_ptr<PictureWriter> openPng(const std::filesystem::path& path, int width, int height,
                                       const PngForm& form, const Settings& settings);
std::unique_ptr<PictureWriter> openRadiance(const std::filesystem::path& path, int width, int height,
                                            const Settings& settings);
std::unique_ptr<PictureWriter> openExr(const std::filesystem::path& path, int width, int height,
                                       ExrDepth depth, const Settings& settings,
                                       const std::vector<std::string>& layerChannels = {});

} // namespace dioptre
