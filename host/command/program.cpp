#include "command/program.h"

#include "base/error.h"
#include "base/heap.h"
#include "base/standard_streams.h"

#include <cstdio>
#include <exception>
#include <system_error>

namespace dioptre
{
namespace
{

ExitCode run(int count, char** arguments, const WindowCommands& windows)
{
    auto code = ExitCode::cannotWrite;
    try {
        code = runCommandLine({arguments + 1, arguments + count}, windows);
    } catch (const std::system_error&) { // the formatter's, where a stream took not even its buffer's worth
        if (std::ferror(stdout) == 0 && std::ferror(stderr) == 0)
            throw;
    }
    const bool taken = standardOutputTaken();
    if (!taken || std::ferror(stderr) != 0)
        fail(ExitCode::cannotWrite, taken ? "standard error takes no more" : "standard output takes no more",
             "make room where it goes, or do not close it");
    return code;
}

} // namespace

int runProgram(int count, char** arguments, const WindowCommands& windows)
{
    holdStandardStreams();
    keepLargeBlocks();
    try {
        return static_cast<int>(run(count, arguments, windows));
    } catch (const Error& error) {
        std::fprintf(stderr, "dioptre: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dioptre: unexpected: %s\n", error.what());
        return static_cast<int>(ExitCode::checkFailed);
    }
}

} // namespace dioptre
