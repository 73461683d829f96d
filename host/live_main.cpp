// The program with windows. It knows all commands; `dioptre` becomes it where one needs a window.
#include "command/program.h"
#include "live/helper.h"
#include "live/live.h"

#include <string_view>

int main(int count, char** arguments)
{
    if (count == 2 && std::string_view(arguments[1]) == dioptre::helperWord)
        return dioptre::runHelper();
    return dioptre::runProgram(count, arguments, {dioptre::live, dioptre::benchReload});
}
