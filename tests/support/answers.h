// Scenes whose heading comment derives what must be seen. Its lines that a machine reads:
//   # size: 9x9                                       pixels; this where unset
//   # samples: 4                                      a pixel; 1 where unset
//   # picture: sky.image = blocks of 8: rg / bw       made for the test, top row first: a letter is 8 x 8
//                                                     texels of black k, full r g b c m y w, or grey h (188)
//   # also: trace.order=breadth-first trace.budget=9  one more rendering, under these overrides
//   # method: phong:8 within 1e-5                   likewise by this method, each tolerance at least so
//   # time: 1.5                                       seconds, for what follows; 0 above the first
//   # expect: pixel 4,4 = 0.04 0.04 0.04 within 1e-5  counted from the lower left corner
//   # expect: pixels 0,0 to 8,3 = 1 0 0 within 1e-5   both corners included
//   # expect: every pixel = 1 1 1 within 1e-5
//   # expect: png 4,4 = 188 128 10                    bytes of the written file
//   # expect: symmetric left-right within 1e-5        or top-bottom, diagonal
#pragma once

#include "base/picture.h"

#include <filesystem>
#include <string>
#include <vector>

namespace dioptre::test
{

struct Expectation {
    enum class Kind { colour, png, leftRight, topBottom, diagonal };
    Kind kind = Kind::colour;
    int line = 0;           // in the file
    double time_s = 0.0;    // of the picture that it speaks of
    int x0 = 0, y0 = 0;     // first pixel
    int x1 = 0, y1 = 0;     // last pixel
    double value[3] = {};   // linear radiance, or bytes
    double tolerance = 0.0; // of each channel
};

// A small picture that a scene asks for.
struct BlockPicture {
    std::string key; // where the scene names it: "sky.image"
    int block = 1;   // texels along a letter's side
    std::vector<std::string> rows;
};

// A method that the scene is drawn by besides.
struct OtherMethod {
    std::string name;
    double tolerance = 0.0;
};

struct Answer {
    std::filesystem::path scene;
    int width = 9;
    int height = 9;
    int samples = 1;
    double time_s = 0.0; // while reading: of the lines to come
    std::vector<BlockPicture> pictures;
    std::vector<std::vector<std::string>> also;
    std::vector<OtherMethod> methods;
    std::vector<Expectation> expectations;
};

// The scenes of tests/scenes/, sorted by name.
std::vector<std::filesystem::path> answerScenes();

// Throws std::invalid_argument with file and line for a line that it does not understand.
Answer readAnswer(const std::filesystem::path& scene);

Picture pictureOf(const BlockPicture& blocks);

// The moments that the answer speaks of, each once.
std::vector<double> momentsOf(const Answer& answer);

// What the picture of a moment fails of the answer, each with file, line, pixel, expected and found. Empty:
// it holds.
std::vector<std::string> failuresOf(const Answer& answer, const Picture& picture, double time_s);

} // namespace dioptre::test
