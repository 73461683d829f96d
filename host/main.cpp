// The only place where an Error becomes a message and an exit code.
#include "base/error.h"
#include "base/heap.h"
#include "command/command.h"

#include <cstdio>
#include <exception>

int main(int count, char** arguments)
{
    dioptre::keepLargeBlocks();
    try {
        return static_cast<int>(dioptre::runCommandLine({arguments + 1, arguments + count}));
    } catch (const dioptre::Error& error) {
        std::fprintf(stderr, "dioptre: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dioptre: unexpected: %s\n", error.what());
        return static_cast<int>(dioptre::ExitCode::checkFailed);
    }
}
