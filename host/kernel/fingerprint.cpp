#include "kernel/reference.h"

#include "base/file.h"
#include "base/text.h"

#include <algorithm>

namespace dioptre
{

unsigned long long shaderFingerprint(const std::filesystem::path& glslFolder)
{
    std::vector<std::filesystem::path> files;
    for (const char* part : {"shared", "kernel", "trace"})
        for (const auto& entry : std::filesystem::directory_iterator(glslFolder / part))
            if (entry.path().extension() == ".glsl")
                files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::string all;
    for (const auto& file : files)
        all += file.filename().string() + '\n' + readFile(file);
    return fingerprint(all);
}

} // namespace dioptre
