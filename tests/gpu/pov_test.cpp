// POV-Ray and dioptre, which share no code, draw the same pictures of scenes written for both (tests/pov).
#include "support/compare.h"
#include "support/process.h"
#include "support/rendering.h"

#include <fmt/format.h>
#include <glm/glm.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <numbers>
#include <stdexcept>
#include <unistd.h>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

constexpr int width = 320, height = 240; // pixels

// Unclamped linear light, one sample in the middle of each pixel.
//
// Both follow the same laws, so a picture differs where a ray just passes an edge in one and just meets it in
// the other: there, and only there, the whole contrast of the edge shows. The bounds are those that the
// project has set itself; measured on llvmpipe: 0 of 76800 pixels and an RMSE below 6e-4 but for `balls`,
// whose chains of curved mirrors and glass before a far checker flip 18 pixels (RMSE 0.0017); in double
// precision it is 1.
constexpr double largestRmse = 0.004;
constexpr double edge = 0.01;
constexpr double largestShareOfEdges = 0.001;

// Away from such edges there is no reason to differ but POV-Ray's output in half floats (2^-12 of a
// value, 2.4e-4 of white) and, for the PNG, llvmpipe's approximate decoding of sRGB textures (6e-4; in double
// precision the same picture comes within 9e-5). A wrong factor, a shift by half a texel or Schlick's formula
// in place of Fresnel's shows here.
constexpr double largestRmseAwayFromEdges = 0.001;

struct Twins {
    std::string name;                   // of the test
    std::string scene;                  // tests/pov/SCENE.toml and SCENE.pov
    std::string declarations;           // for the one, as Declare=NAME=VALUE
    std::vector<std::string> overrides; // for the other, as --set
};

void PrintTo(const Twins& twins, std::ostream* out)
{
    *out << twins.name;
}

// A folder for one test's files, removed at its end.
struct Folder {
    std::filesystem::path path;
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "dioptre-pov-").string() +
                           std::string(6, 'X'); // mkdtemp replaces them
        if (mkdtemp(name.data()) == nullptr)
            throw std::runtime_error("no temporary folder");
        path = name;
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder()
    {
        std::filesystem::remove_all(path);
    }
};

// How much of a patch of sky about a direction is seen along another; 1 in its middle.
double glow(const glm::dvec3& direction, const glm::dvec3& middle)
{
    return std::exp(12.0 * (glm::dot(direction, glm::normalize(middle)) - 1.0));
}

// A sky that looks different in every direction and after every symmetry. It is the same at both poles, for
// POV-Ray wraps a picture's rows as it does its columns: within half a texel of a pole it mixes the top row
// with the bottom row. Both take the middle of a texel for its place, so a picture of few texels is right: a
// shift of half a texel would be seen.
Picture paintedSky()
{
    const int columns = 64, rows = 32; // texels
    Picture sky{columns, rows, PixelFormat::float32, {}, {}};
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            const double latitude = ((row + 0.5) / rows - 0.5) * std::numbers::pi;
            const double longitude = (column + 0.5) / columns * 2.0 * std::numbers::pi;
            const double ring = std::cos(latitude);
            const glm::dvec3 direction(ring * std::sin(longitude), std::sin(latitude),
                                       -ring * std::cos(longitude));
            const double waves = ring * ring;
            const double rgb[] = {
                0.25 + 0.15 * waves * std::sin(5.0 * longitude) + 0.7 * glow(direction, {1.0, 0.6, 0.3}),
                0.3 + 0.1 * waves * std::sin(3.0 * longitude + 4.0 * latitude) +
                    0.6 * glow(direction, {-0.3, 0.2, 1.0}),
                0.4 + 0.2 * waves * std::sin(2.0 * longitude) + 0.4 * glow(direction, {-1.0, -0.5, -0.2})};
            for (const double value : rgb)
                sky.floats.push_back(static_cast<float>(value));
            sky.floats.push_back(1.0F);
        }
    return sky;
}

const std::filesystem::path sources = DIOPTRE_SOURCE_DIR;

// The scenes of both and the pictures that they need, side by side: POV-Ray may read and write where it is
// run.
void furnish(const std::filesystem::path& folder)
{
    for (const auto& entry : std::filesystem::directory_iterator(sources / "tests" / "pov"))
        std::filesystem::copy(entry.path(), folder);
    for (const char* picture : {"floor.png", "wave.png", "planet.png", "sky.exr"})
        std::filesystem::copy(sources / "textures" / picture, folder);
    writeExr(folder / "panorama.exr", paintedSky(), ExrDepth::half, {});
    writePng(folder / "panorama.png", paintedSky(), {}, {});
}

// POV-Ray's picture. No antialiasing, so no jitter; no display, no text but of errors.
Picture drawWithPovRay(const std::filesystem::path& folder, const std::string& scene, int width_px,
                       int height_px, const std::string& declarations)
{
    const Outcome outcome =
        run(fmt::format("cd '{}' && povray +I{}.pov +Opov-ray.exr +FE +W{} +H{} -A -D -V -GA +GF +WT2 {}",
                        folder.string(), scene, width_px, height_px, declarations));
    if (outcome.code == 127)
        throw std::runtime_error("POV-Ray is missing: install the package povray");
    if (outcome.code != 0)
        throw std::runtime_error("POV-Ray ended with an error: " + outcome.error);
    return readPicture(folder / "pov-ray.exr");
}

// Each pixel the mean of a square of them.
Picture shrunk(const Picture& picture, int factor)
{
    Picture small{picture.width / factor, picture.height / factor, PixelFormat::float32, {}, {}};
    small.floats.resize(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height));
    for (int y = 0; y < small.height * factor; ++y)
        for (int x = 0; x < small.width * factor; ++x) {
            const auto from = static_cast<std::size_t>(y * picture.width + x);
            const auto to = static_cast<std::size_t>(y / factor * small.width + x / factor);
            for (std::size_t channel = 0; channel < 4; ++channel)
                small.floats[4 * to + channel] +=
                    picture.floats[4 * from + channel] / static_cast<float>(factor * factor);
        }
    return small;
}

// Over the pixels that no edge has changed.
double rmseAwayFromEdges(const Picture& actual, const Picture& expected)
{
    double sum = 0.0;
    std::size_t count = 0;
    for (std::size_t first = 0; first < actual.floats.size(); first += 4) {
        double squares = 0.0, worst = 0.0;
        for (std::size_t i = first; i < first + 3; ++i) {
            const double off = std::abs(static_cast<double>(actual.floats[i]) - expected.floats[i]);
            squares += off * off;
            worst = std::max(worst, off);
        }
        sum += worst > edge ? 0.0 : squares;
        count += worst > edge ? 0 : 3;
    }
    return std::sqrt(sum / static_cast<double>(count));
}

class PovRay : public testing::TestWithParam<Twins>
{
};

INSTANTIATE_TEST_SUITE_P(Scenes, PovRay,
                         testing::Values(Twins{"Balls", "balls", "", {}}, Twins{"Shapes", "shapes", "", {}},
                                         Twins{"Pool", "pool", "", {}}, Twins{"Sky", "sky", "", {}},
                                         Twins{"SkyOfAPngMirrored",
                                               "sky",
                                               "Declare=MirrorU=1 Declare=Png=1",
                                               {"sky.mirror_u=true", "sky.image=\"panorama.png\""}}),
                         [](const auto& info) { return info.param.name; });

} // namespace

TEST_P(PovRay, DrawsTheSamePicture)
{
    const Folder folder;
    furnish(folder.path);
    const auto expected =
        drawWithPovRay(folder.path, GetParam().scene, width, height, GetParam().declarations);
    const auto actual = renderScene(folder.path / (GetParam().scene + ".toml"),
                                    {width, height, 1, GetParam().overrides, "auto"})
                            .picture;

    const auto difference = compare(actual, expected, edge);
    const double away = rmseAwayFromEdges(actual, expected);
    std::cout << fmt::format("{}: RMSE {:.6f}, {} of {} pixels over {}, RMSE of the others {:.6f}\n",
                             GetParam().name, difference.rmse, difference.over, difference.pixels, edge,
                             away);
    EXPECT_LE(difference.rmse, largestRmse);
    EXPECT_LE(static_cast<double>(difference.over),
              largestShareOfEdges * static_cast<double>(difference.pixels));
    EXPECT_LE(away, largestRmseAwayFromEdges);
    if (HasFailure())
        ADD_FAILURE() << saveForTheEye("pov-" + GetParam().name, actual, expected);
}

// The scene that tests/pov_anchor times. POV-Ray has no smaller levels of a picture, so both draw it at a
// size at which the largest level is the right one nearly everywhere, with 4 x 4 samples for each pixel that
// is compared. What is left is the far floor in the mirror ball, the planet's limb, the edges of the print,
// where POV-Ray's picture wraps, and highlights without a tint: on llvmpipe an RMSE of 0.0016 and 465 of
// 160000 pixels that are off by more than 3 of 255. No lamp's ball in the sun's way makes that 0.010 and 867,
// a tenth more shadow of the glass 0.0025 and 3073, no highlight on the cylinder 0.0016 and 1241.
TEST(PovRayStillLife, ShowsTheSameScene)
{
    constexpr int size_px = 400, samples = 4; // along each side
    const Folder folder;
    furnish(folder.path);
    const auto scene = sources / "glsl" / "scenes" / "still_life.toml";
    const auto expected =
        shrunk(drawWithPovRay(folder.path, "still_life", size_px * samples, size_px * samples, ""), samples);
    const Request request{size_px * samples, size_px * samples, 1, ownPictures(scene), "auto"};
    const auto actual = shrunk(renderScene(scene, request).picture, samples);

    const double rmse = compare(actual, expected, edge).rmse;
    const auto seen = compareEncoded(actual, expected, 3.0);
    std::cout << fmt::format("RMSE {:.6f}, {} of {} pixels over 3 of 255\n", rmse, seen.over, seen.pixels);
    EXPECT_LE(rmse, 0.002);
    EXPECT_LE(seen.over, seen.pixels / 200);
    if (HasFailure())
        ADD_FAILURE() << saveForTheEye("pov-still-life", actual, expected);
}
