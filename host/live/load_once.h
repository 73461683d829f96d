// From a request to what the device must do: files read, scene planned, shaders assembled.
#pragma once

#include "live/loader.h"

namespace dioptre
{

// The pictures that were loaded last: an edit of a number does not decode them again.
struct KeptPictures {
    std::string fingerprint; // of their files
    std::vector<std::vector<Picture>> pictures;
    std::vector<Picture> sky;
    std::optional<double> skyBrightness;
};

// By the place of a method among those that are drawn.
using KeptForMethods = std::array<KeptPictures, 2>;

// What changes when one of the files does.
std::string stampOf(const std::vector<std::filesystem::path>& files);

// Never throws: what goes wrong is in the outcome.
LoadOutcome loadOnce(const LoadRequest& request, const DeviceTraits& device, KeptForMethods& kept);

} // namespace dioptre
