// What the fuzz targets share. Each is one function from bytes to a judgement: libFuzzer calls it over and
// over and takes a crash, an exception that leaves it, a sanitizer's finding, a long run or too much memory
// for a defect.
#pragma once

#include "base/error.h"
#include "base/write_file.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <unistd.h>

// The name is libFuzzer's.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace dioptre::fuzz
{

inline const std::filesystem::path glslOfSources = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl";

inline std::string textOf(const std::uint8_t* data, std::size_t size)
{
    return data == nullptr ? std::string() : std::string(reinterpret_cast<const char*>(data), size);
}

// An empty folder of this process's own in $TMPDIR, which tests/run_fuzz puts into memory and removes.
inline std::filesystem::path emptyFolder()
{
    const auto folder = std::filesystem::temp_directory_path() / ("dioptre_fuzz_" + std::to_string(getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

inline void write(const std::filesystem::path& path, std::string_view bytes)
{
    std::ofstream(path, std::ios::binary) << bytes;
}

// What must hold whatever the input; libFuzzer keeps one where it does not.
inline void demand(bool holds)
{
    if (!holds)
        std::abort();
}

// Whether the action came to its end; a reason that the input is to blame for is its other good outcome.
template <class Action>
bool succeeds(const Action& action)
{
    try {
        action();
        return true;
    } catch (const Error& error) {
        demand(error.code() == ExitCode::badInput || error.code() == ExitCode::inputMissing ||
               error.code() == ExitCode::usage);
        demand(!error.complaints().empty() && *error.what() != '\0');
        return false;
    }
}

} // namespace dioptre::fuzz
