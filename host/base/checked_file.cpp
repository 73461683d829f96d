#include "base/checked_file.h"

#include "base/error.h"

namespace dioptre
{

CheckedFile::CheckedFile(const std::filesystem::path& path)
    : path_(path), pending_(path), out_(pending_.path(), std::ios::binary | std::ios::trunc)
{
}

void CheckedFile::write(const char* bytes, std::size_t count)
{
    out_.write(bytes, static_cast<std::streamsize>(count));
}

std::uint64_t CheckedFile::position()
{
    return static_cast<std::uint64_t>(out_.tellp());
}

void CheckedFile::moveTo(std::uint64_t position)
{
    out_.seekp(static_cast<std::streamoff>(position));
}

void CheckedFile::check() const
{
    if (!out_)
        fail(ExitCode::cannotWrite, {path_.string()}, "the file could not be written to its end",
             "make room on the disk, or choose another place with -o");
}

void CheckedFile::finish()
{
    out_.close(); // a full disk may be noticed only now
    check();
    pending_.commit();
}

} // namespace dioptre
