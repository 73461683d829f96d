#include "base/write_file.h"

#include "base/error.h"
#include "base/file.h"

#include <fstream>

namespace dioptre
{

void writeFile(const std::filesystem::path& path, std::string_view bytes)
{
    PendingFile pending(path);
    std::ofstream out(pending.path(), std::ios::binary | std::ios::trunc);
    out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    out.close();
    if (!out)
        fail(ExitCode::cannotWrite, {path.string()}, "the file could not be written to its end",
             "make room on the disk, or choose another place with -o");
    pending.commit();
}

} // namespace dioptre
