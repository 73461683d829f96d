// Pictures that stand on one another, put together to one without more than a few rows in memory.
#pragma once

#include "base/picture.h"

#include <functional>
#include <optional>

namespace dioptre
{

// The kinds of file that the writers write, told by content.
enum class StoredKind { png, radiance, exr };

// By the extension of a name; none for any other than .png, .hdr and .exr.
std::optional<StoredKind> storedKindNamed(const std::filesystem::path& name);

// Throws inputMissing; badInput for anything else.
StoredKind storedKind(const std::filesystem::path& path);

// What a picture's file says before its pixels.
struct StoredHead {
    StoredKind kind = StoredKind::png;
    int width = 0;    // pixels
    int height = 0;   // pixels
    std::string form; // bits, channels: what must agree before pictures can be put together; for messages too
};

// Throws inputMissing; badInput for what is broken, and for what the writers do not write.
StoredHead readStoredHead(const std::filesystem::path& path);

// What is put together.
struct PictureStack {
    std::vector<std::filesystem::path> topDown; // one kind, width and form
    int width = 0;                              // pixels
    int height = 0;                             // pixels: the sum of theirs
    Settings settings;                          // of the whole
};

// Writes the file that the kind's writer would have written of the whole. `progress` is told the share of
// rows done. Throws badInput for what is broken or cut short, cannotWrite, and what `progress` throws.
void writeStack(const PictureStack& stack, const std::filesystem::path& output,
                const std::function<void(double)>& progress);

} // namespace dioptre
