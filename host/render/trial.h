// A program with all that it reads but the pictures' contents: another process compiles and draws it first,
// so that what a driver does not survive, or never ends, is not met here.
#pragma once

#include "render/assembled_part.h"
#include "render/plain.h"

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace dioptre
{

// Of the inputs of a vertex stage that is fed corners, by location: numbers each.
inline constexpr std::array cornerSizes{4, 3, 3, 3};

struct ProgramTrial {
    std::string fragment;
    std::string vertex; // "" for the plain full-screen triangle
    std::map<std::string, std::vector<float>> blocks;
    HostNumbers uniforms; // as many numbers as a uniform's type wants, or fewer: then the rest is 0
    std::vector<std::pair<std::string, TextureShape>> textures; // by sampler
    bool marksEndedLoops = false;                               // as PlainText::checksLoops
    std::vector<float> corners{}; // of triangles, cornerSizes' numbers each; empty: the full-screen triangle
};

// What came of it.
struct TrialOutcome {
    std::vector<LogMessage> messages; // of a driver that refuses it; empty where it drew
    bool inVertexStage = false;       // whose lines they name
    double compile_ms = 0.0;          // compile and link
    double firstDraw_ms = 0.0;        // of one pixel
    std::size_t endedLoops = 0;       // pixels whose loops the driver ended, of trialSize_px
    std::array<double, 4> mean{};     // of the picture's channels
};

// Of what is drawn: each sample once, small.
inline const glm::ivec2 trialSize_px{96, 54};

// `packed`: of a picture of any size.
ProgramTrial trialOf(const AssembledPart& part, const PackedScene& packed);
ProgramTrial trialOf(const LoadedPlain& loaded, const PlainSettings& plain);

// Compiles and draws it on the current context, in the format and by the calls that a Drawing uses, so that a
// driver which keeps compiled shaders has it for the next process. A draw that
// takes longer than the limit throws as waitForDevice() does.
TrialOutcome tryProgram(const ProgramTrial& trial, double drawLimit_s);

} // namespace dioptre
