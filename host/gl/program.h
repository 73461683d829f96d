// Compiling and linking one fragment shader over a full-screen triangle, and looking at what it asks for.
#pragma once

#include "gl/object.h"

#include <map>
#include <string>
#include <vector>

namespace dioptre
{

// A linked program and what it reads.
struct Program {
    ProgramName name;
    std::map<std::string, GLint>
        uniforms; // active uniforms outside blocks ("u_x", arrays without "[0]") by location
    std::map<std::string, GLuint> uniformBlocks; // active blocks by index
};

// An active uniform outside blocks, as glGetActiveUniform tells of it.
struct ActiveUniform {
    std::string name; // arrays without "[0]"
    GLint location = -1;
    GLenum type = 0;
    GLint elements = 1;
};
std::vector<ActiveUniform> activeUniformsOf(const Program& program);

// One message of a driver's log, mapped out of its format.
struct LogMessage {
    int line = 0;   // of the text that was sent, counted from 1; 0 where the driver names none
    int column = 0; // in that line, counted from 1; 0 where the driver names none
    std::string text;
    bool collapsed = false; // the column is one of the line with its macros expanded and each run of blanks
                            // and comments made one blank, as Mesa's preprocessor hands it on
};

// Reads Mesa's "0:12(11): error: …", NVIDIA's "0(12) : error C1503: …" and the "ERROR: 0:12: …" of AMD, Intel
// and ANGLE. Lines in none of these formats are kept with line 0.
std::vector<LogMessage> parseLog(const std::string& log);

// A compile or link that failed; main() never sees it: render/ maps its lines to files first.
struct ShaderError {
    std::vector<LogMessage> messages;
    bool inVertexStage = false; // whether the lines are those of the vertex shader
};

// main() of a vertex shader: one triangle that covers the viewport, from gl_VertexID alone. `statements` are
// run for each of its three vertices.
std::string fullScreenMain(const std::string& statements = "");

// Compiles `fragmentText` and `vertexText` (whole, with their #version) and links them. Throws ShaderError.
Program buildProgram(const std::string& fragmentText,
                     const std::string& vertexText = "#version 330 core\n" + fullScreenMain());

} // namespace dioptre
