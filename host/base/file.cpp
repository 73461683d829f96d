#include "base/file.h"

#include "base/error.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sstream>
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

} // namespace

std::ifstream openFile(const fs::path& path)
{
    std::error_code ignored;
    if (fs::is_directory(path, ignored))
        fail(ExitCode::inputMissing, {path.string()}, "is a folder", "name a file in it");
    errno = 0;
    std::ifstream in(path, std::ios::binary);
    if (!in.is_open())
        failToRead(path);
    return in;
}

std::string readFile(const fs::path& path)
{
    std::ifstream in = openFile(path);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    if (in.bad())
        failToRead(path);
    return std::move(bytes).str();
}

// A link is followed, so that the file behind it is replaced and not the link; devices are refused, since the
// rename would put a plain file in their place.
PendingFile::PendingFile(fs::path target) : target_(std::move(target))
{
    std::error_code ignored;
    if (fs::is_symlink(target_, ignored))
        target_ = fs::weakly_canonical(target_);
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
