#include "support/glslang.h"

#include "support/process.h"

#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace dioptre::test
{
namespace
{

// The validator knows `precise` from GLSL 4.00 on alone, of which GL_ARB_gpu_shader5 is a part.
std::string forTheValidator(std::string text)
{
    const std::string version = "#version 330";
    const auto at = text.find(version);
    if (at != std::string::npos && text.find("GL_ARB_gpu_shader5 : require") != std::string::npos)
        text.replace(at, version.size(), "#version 400");
    return text;
}

} // namespace

std::string complaints(const std::map<std::string, std::string>& shaders)
{
    const auto folder = std::filesystem::temp_directory_path() / ("dioptre-glsl-" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    std::string command = "cd '" + folder.string() + "' && glslangValidator";
    for (const auto& [name, text] : shaders) {
        std::ofstream(folder / name) << forTheValidator(text);
        command += " '" + name + "'";
    }
    const auto outcome = run(command);
    std::filesystem::remove_all(folder);
    return outcome.code == 0 ? "" : "exit code " + std::to_string(outcome.code) + "\n" + outcome.out;
}

} // namespace dioptre::test
