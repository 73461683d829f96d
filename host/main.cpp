// The program without windows: for them it becomes the one beside it.
#include "command/become_live.h"
#include "command/program.h"

int main(int count, char** arguments)
{
    const auto become = [&](const auto&) { return dioptre::becomeLive(arguments); };
    return dioptre::runProgram(count, arguments, {become, become});
}
