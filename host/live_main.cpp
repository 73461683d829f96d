// The program with windows. It knows all commands; `dioptre` becomes it where one needs a window.
#include "command/program.h"
#include "live/live.h"

int main(int count, char** arguments)
{
    return dioptre::runProgram(count, arguments, {dioptre::live, dioptre::benchReload});
}
