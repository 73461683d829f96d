#include "command/become_live.h"

#include <filesystem>
#include <unistd.h>

namespace dioptre
{

ExitCode becomeLive(char** arguments)
{
    const auto program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "dioptre-live";
    ::execv(program.c_str(), arguments);
    fail(ExitCode::noOpenGl, "this build has no window",
         "run it by ./dioptre, which builds it, or configure with -DDIOPTRE_LIVE=ON");
}

} // namespace dioptre
