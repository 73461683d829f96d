#include "base/write_file.h"

#include "base/checked_file.h"

namespace dioptre
{

void writeFile(const std::filesystem::path& path, std::string_view bytes)
{
    CheckedFile file(path);
    file.write(bytes.data(), bytes.size());
    file.finish();
}

} // namespace dioptre
