// The only place where an Error becomes a message and an exit code.
#include "base/error.h"
#include "base/heap.h"
#include "base/standard_streams.h"
#include "command/command.h"

#include <cstdio>
#include <exception>

namespace
{

dioptre::ExitCode run(int count, char** arguments)
{
    const auto code = dioptre::runCommandLine({arguments + 1, arguments + count});
    if (!dioptre::standardOutputTaken())
        dioptre::fail(dioptre::ExitCode::cannotWrite, "standard output takes no more",
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
