#include "base/file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <system_error>
#include <unistd.h>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

[[noreturn]] void failToWrite(const fs::path& path, std::string_view what)
{
    fail(ExitCode::cannotWrite, {path.string()}, fmt::format("cannot be written ({})", what),
         "choose another place with -o");
}

[[noreturn]] void failToRead(const fs::path& path)
{
    fail(ExitCode::inputMissing, {path.string()},
         fmt::format("cannot be read ({})", std::strerror(errno != 0 ? errno : EIO)), "check the path");
}

// Creates a file that did not exist before, with the permissions that the umask leaves. It keeps the
// extension of `target`, for encoders that go by it.
fs::path createBeside(const fs::path& target)
{
    for (int number = 0;; ++number) {
        fs::path name = target.parent_path() / fmt::format(".dioptre-{}-{}.part", ::getpid(), number);
        name += target.extension();
        const int descriptor = ::open(name.c_str(), O_CREAT | O_EXCL | O_WRONLY | O_CLOEXEC, 0666);
        if (descriptor >= 0) {
            ::close(descriptor);
            return name;
        }
        if (errno != EEXIST)
            failToWrite(target, std::strerror(errno));
    }
}

constexpr int mostLinks = 40; // from one to the next, as Linux has it

// Twice what the largest picture has in floats: none that can be read is refused.
constexpr std::uintmax_t mostBytes = std::uintmax_t{4} << 30;

[[noreturn]] void refuseSize(const fs::path& path)
{
    fail(ExitCode::badInput, {path.string()}, "is too large", "name a file of at most 4 GiB");
}

} // namespace

std::ifstream openFile(const fs::path& path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        fail(ExitCode::inputMissing, {path.string()}, "is a folder", "name a file in it");
    // Those of the kind of /dev/zero never end.
    if (fs::is_character_file(path, ignored) || fs::is_block_file(path, ignored))
        fail(ExitCode::inputMissing, {path.string()}, "is a device", "name a file");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in.is_open())
        failToRead(path);
    return in;
}

std::string readFile(const fs::path& path)
{
    std::ifstream in = openFile(path);
    std::error_code ignored;
    const bool sized = fs::is_regular_file(path, ignored);
    const std::uintmax_t size = sized ? fs::file_size(path, ignored) : 0;
    if (sized && !ignored && size > mostBytes)
        refuseSize(path);
    std::string bytes;
    bytes.reserve(sized && !ignored ? size : 0);
    std::string block(1U << 18, '\0');
    while (in && bytes.size() <= mostBytes) { // a pipe does not tell its size, and one in /proc tells 0
        in.read(block.data(), static_cast<std::streamsize>(block.size()));
        bytes.append(block, 0, static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad())
        failToRead(path);
    if (bytes.size() > mostBytes)
        refuseSize(path);
    return bytes;
}

// A link is followed, so that the file behind it is replaced and not the link; devices are refused, since the
// rename would put a plain file in their place.
PendingFile::PendingFile(fs::path target) : target_(std::move(target))
{
    std::error_code ignored;
    for (int links = 0; fs::is_symlink(target_, ignored); ++links) {
        if (links == mostLinks)
            failToWrite(target_, "a circle of links");
        target_ = target_.parent_path() / fs::read_symlink(target_, ignored);
    }
    const fs::path folder = target_.has_parent_path() ? target_.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, ignored))
        fail(ExitCode::cannotWrite, {target_.string()}, fmt::format("there is no folder {}", folder.string()),
             "make it, or choose another place with -o");
    if (!target_.has_filename() || (fs::exists(target_, ignored) && !fs::is_regular_file(target_, ignored)))
        fail(ExitCode::cannotWrite, {target_.string()}, "is not a regular file", "name a file with -o");
    temporary_ = createBeside(target_);
}

PendingFile::~PendingFile()
{
    std::error_code ignored;
    if (!committed_)
        fs::remove(temporary_, ignored);
}

const fs::path& PendingFile::path() const
{
    return temporary_;
}

void PendingFile::commit()
{
    std::error_code fault;
    fs::rename(temporary_, target_, fault);
    if (fault)
        failToWrite(target_, fault.message());
    committed_ = true;
}

} // namespace dioptre
