#include "support/glslang.h"

#include "support/process.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace dioptre::test
{

std::string complaints(const std::map<std::string, std::string>& shaders)
{
    const auto folder = std::filesystem::temp_directory_path() / ("dioptre-glsl-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    std::string command = "cd '" + folder.string() + "' && glslangValidator";
    for (const auto& [name, text] : shaders) {
        std::ofstream(folder / name) << text;
        command += " '" + name + "'";
    }
    const auto outcome = run(command);
    std::filesystem::remove_all(folder);
    return outcome.code == 0 ? "" : "exit code " + std::to_string(outcome.code) + "\n" + outcome.out;
}

} // namespace dioptre::test
