// Reading, and writing that leaves either the finished file or none.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

namespace dioptre
{

// The file to be read as its bytes are. Throws inputMissing when it cannot be opened or is a device.
std::ifstream openFile(const std::filesystem::path& path);

// The file's bytes. Throws inputMissing when it cannot be read or is a device, badInput beyond 4 GiB.
std::string readFile(const std::filesystem::path& path);

// A temporary name beside `target`; the file written there is renamed to `target` by commit(), and removed if
// commit() was never reached. The constructor throws cannotWrite when the folder is missing or not writable.
class PendingFile
{
public:
    explicit PendingFile(std::filesystem::path target);
    PendingFile(const PendingFile&) = delete;
    PendingFile& operator=(const PendingFile&) = delete;
    ~PendingFile();

    const std::filesystem::path& path() const; // where to write
    void commit();                             // throws cannotWrite

private:
    std::filesystem::path target_;
    std::filesystem::path temporary_;
    bool committed_ = false;
};

} // namespace dioptre
