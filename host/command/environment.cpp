#include "command/environment.h"

#include "base/file.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <pwd.h>
#include <sched.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace dioptre
{
namespace
{

std::string variable(const char* name)
{
    const char* value = std::getenv(name);
    return value != nullptr ? value : "";
}

// Of this process: "dioptre", "llvmpipe-0", "dioptre:disk$0".
std::vector<std::string> threadNames()
{
    std::vector<std::string> names;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task"))
        names.push_back(readFile(task.path() / "comm"));
    return names;
}

std::ptrdiff_t threadsCalled(const char* part)
{
    const auto names = threadNames();
    return std::ranges::count_if(
        names, [part](const std::string& name) { return name.find(part) != std::string::npos; });
}

// A thread names itself once it runs, and that of Mesa's cache runs at the lowest priority: on a busy machine
// it takes a while.
bool cacheThreadAppears(const ContextInfo& context)
{
    using namespace std::chrono_literals;
    const bool expected = context.version.find("Mesa") != std::string::npos &&
                          variable("MESA_SHADER_CACHE_DISABLE").empty() &&
                          variable("MESA_GLSL_CACHE_DISABLE").empty();
    for (int tries = 0; threadsCalled("disk$") == 0; ++tries) {
        if (!expected || tries == 100)
            return false;
        std::this_thread::sleep_for(20ms);
    }
    return true;
}

// The folder below which Mesa keeps its cache (src/util/disk_cache_os.c): the home is that of the user
// database.
std::filesystem::path cacheParent()
{
    for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"})
        if (const std::string folder = variable(name); !folder.empty())
            return folder;
    const passwd* user = ::getpwuid(::getuid());
    return user != nullptr ? std::filesystem::path(user->pw_dir) / ".cache" : std::filesystem::path();
}

// Whether it, or the nearest folder above it that exists, can be written to.
bool canBeWritten(std::filesystem::path folder)
{
    std::error_code ignored;
    while (!folder.empty() && !std::filesystem::exists(folder, ignored) && folder != folder.parent_path())
        folder = folder.parent_path();
    return ::access(folder.c_str(), W_OK) == 0;
}

void findCache(DriverEnvironment& environment, const ContextInfo& context, bool threadRuns)
{
    const std::string parent = cacheParent().string();
    environment.shaderCache = threadRuns ? "on" : "off";
    if (threadRuns) {
        environment.cacheReason = "below " + parent;
        return;
    }
    for (const char* name : {"MESA_SHADER_CACHE_DISABLE", "MESA_GLSL_CACHE_DISABLE"})
        if (const std::string value = variable(name); !value.empty()) {
            environment.cacheReason = fmt::format("{} is {}", name, value);
            return;
        }
    if (!canBeWritten(parent)) {
        environment.cacheReason = parent + " cannot be written to";
        return;
    }
    environment.shaderCache = "unknown";
    const bool mesa = context.version.find("Mesa") != std::string::npos;
    environment.cacheReason = mesa ? "no thread of Mesa's keeps one" : "not a driver of Mesa's";
}

// Of this process, which may be kept from some of the machine's.
int coresAllowed()
{
    cpu_set_t allowed;
    CPU_ZERO(&allowed);
    return ::sched_getaffinity(0, sizeof(allowed), &allowed) == 0 ? CPU_COUNT(&allowed) : 1;
}

} // namespace

DriverEnvironment driverEnvironment(const ContextInfo& context)
{
    DriverEnvironment environment;
    findCache(environment, context, cacheThreadAppears(context));
    environment.rasterThreads = static_cast<int>(threadsCalled("llvmpipe-"));
    environment.threadsAsked = variable("LP_NUM_THREADS");
    environment.cores = coresAllowed();
    return environment;
}

} // namespace dioptre
