// The only place where an Error becomes a message and an exit code.
#include "base/error.h"
#include "base/heap.h"
#include "base/standard_streams.h"
#include "command/command.h"

#include <cstdio>
#include <exception>
#include <system_error>

namespace
{

dioptre::ExitCode run(int count, char** arguments)
{
    auto code = dioptre::ExitCode::cannotWrite;
    try {
        code = dioptre::runCommandLine({arguments + 1, arguments + count});
    } catch (const std::system_error&) { // the formatter's, where a stream took not even its buffer's worth
        if (std::ferror(stdout) == 0 && std::ferror(stderr) == 0)
            throw;
    }
    const bool taken = dioptre::standardOutputTaken();
    if (!taken || std::ferror(stderr) != 0)
        dioptre::fail(dioptre::ExitCode::cannotWrite,
                      taken ? "standard error takes no more" : "standard output takes no more",
                      "make room where it goes, or do not close it");
    return code;
}

} // namespace

int main(int count, char** arguments)
{
    dioptre::holdStandardStreams();
    dioptre::keepLargeBlocks();
    try {
        return static_cast<int>(run(count, arguments));
    } catch (const dioptre::Error& error) {
        std::fprintf(stderr, "dioptre: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dioptre: unexpected: %s\n", error.what());
        return static_cast<int>(dioptre::ExitCode::checkFailed);
    }
}
