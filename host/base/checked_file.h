// A file that grows as its bytes come, so that no more than a buffer of it is in memory.
#pragma once

#include "base/file.h"

#include <cstddef>
#include <cstdint>
#include <fstream>

namespace dioptre
{

// Written by way of a PendingFile: whole under its name in the end, or not there.
class CheckedFile
{
public:
    // Throws cannotWrite where no file can be made.
    explicit CheckedFile(const std::filesystem::path& path);

    // Keeps silent about faults, for encoders in C and destructors that no exception may pass: the first one
    // is remembered, nothing more is written, and check() and finish() tell of it.
    void write(const char* bytes, std::size_t count);
    std::uint64_t position();
    void moveTo(std::uint64_t position);

    void check() const; // throws cannotWrite after a fault
    void finish();      // gives the file its name; throws cannotWrite

private:
    std::filesystem::path path_; // as the messages call it
    PendingFile pending_;
    std::ofstream out_;
};

} // namespace dioptre
