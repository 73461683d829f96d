// A scene and dioptre's shaders in a folder of their own, to be edited without harm.
#pragma once

#include "command/input.h"

#include <filesystem>
#include <string>

namespace dioptre
{

class EditedCopy
{
public:
    // Of a scene. Throws usage for a plain shader, and cannotWrite.
    explicit EditedCopy(const Input& scene);
    EditedCopy(const EditedCopy&) = delete;
    EditedCopy& operator=(const EditedCopy&) = delete;
    ~EditedCopy(); // removes the folder

    const std::filesystem::path& scene() const
    {
        return scene_;
    }
    const std::filesystem::path& shader() const // a trivial plain one
    {
        return shader_;
    }
    std::filesystem::path glslFolder() const
    {
        return folder_ / "glsl";
    }

    // Each is saved as an editor does, and gives another picture for another `share` of 0 to 1: a value of
    // the scene; the one colour of the trivial shader, which is grey of that share; and the tracer's last
    // line.
    void editValue(double share);
    void editTrivial(double share);
    void editTracer(double share);

private:
    std::filesystem::path folder_;
    std::filesystem::path scene_;
    std::filesystem::path shader_;
    std::string sceneText_;
    std::string tracerText_;
};

} // namespace dioptre
