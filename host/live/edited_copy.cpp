#include "live/edited_copy.h"

#include "base/error.h"
#include "base/file.h"
#include "base/write_file.h"
#include "scene/document_edit.h"
#include "scene/load.h"

#include <fmt/format.h>

#include <unistd.h>

namespace dioptre
{
namespace
{

namespace fs = std::filesystem;

// The tracer's last assignment: what it gives is what is seen.
constexpr std::string_view lastLine = "o_sum = sum;";

} // namespace

EditedCopy::EditedCopy(const Input& scene)
{
    if (scene.plainShader)
        fail(ExitCode::usage, scene.path.string() + " is a plain shader, and --reload edits a scene",
             "name a scene");
    folder_ = fs::temp_directory_path() / fmt::format("dioptre-reload-{}", ::getpid());
    fs::create_directories(folder_);
    fs::copy(dioptre::glslFolder(), glslFolder(), fs::copy_options::recursive);
    scene_ = folder_ / "scene.toml";
    shader_ = folder_ / "trivial.frag";
    sceneText_ = readSceneText(scene.path);
    tracerText_ = readFile(glslFolder() / "ray_trace.frag");
    if (tracerText_.find(lastLine) == std::string::npos)
        fail(ExitCode::badInput, {(glslFolder() / "ray_trace.frag").string()},
             fmt::format("it holds no '{}'", lastLine), "undo the edit of it");
    writeFile(scene_, sceneText_);
    editTrivial(0.5);
}

EditedCopy::~EditedCopy()
{
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
}

void EditedCopy::editValue(double share)
{
    writeFile(scene_, withValues(sceneText_, scene_.string(),
                                 {fmt::format("camera.fov_y_deg={:.6f}", 30.0 + 30.0 * share)}));
}

void EditedCopy::editTrivial(double share)
{
    writeFile(shader_, fmt::format("void mainImage(out vec4 colour, in vec2 pixel)\n{{\n"
                                   "    colour = vec4(vec3({:.9f}), 1.0);\n}}\n",
                                   share));
}

void EditedCopy::editTracer(double share)
{
    std::string text = tracerText_;
    text.replace(text.find(lastLine), lastLine.size(),
                 fmt::format("o_sum = vec4({:.9f} * sum.rgb, sum.a);", 0.5 + 0.5 * share));
    writeFile(glslFolder() / "ray_trace.frag", text);
}

} // namespace dioptre
