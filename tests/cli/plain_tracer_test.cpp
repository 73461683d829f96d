// The tracer in plain Python, against which dioptre's speed is measured, truly traces scenes.
#include "support/compare.h"
#include "support/in_a_folder.h"

#include "base/file.h"
#include "base/write_file.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iostream>
#include <stdexcept>

using namespace dioptre;
using dioptre::test::run;

namespace
{

const std::string tracer = "python3 '" DIOPTRE_SOURCE_DIR "/host/command/plain_tracer.py' ";
const std::string stillLife = "'" DIOPTRE_SOURCE_DIR "/glsl/scenes/still_life.toml' ";

// Every shape and kind of surface, and nothing that the plain tracer replaces.
constexpr const char* everything = R"(
[camera]
eye = [0.3, 1.4, 6.0]
target = [0.0, 0.7, 0.0]
fov_y_deg = 36.0
[sky]
gradient = [[0.3, 0.2, 0.2], [0.8, 0.8, 0.7], [0.2, 0.3, 0.6]]
[material.floor]
pattern = "checker"
colours = [[0.7, 0.6, 0.5], [0.2, 0.3, 0.3]]
size = 1.3
[material.red]
colour = "#c03020"
[material.blue]
colour = [0.1, 0.2, 0.6]
[material.mirror]
mirror = 0.8
mirror_colour = [1.0, 0.9, 0.8]
colour = [0.2, 0.2, 0.2]
[material.glass]
transmit = 1.0
ior = 1.5
colour = [0.6, 0.8, 0.7]
absorption = [0.9, 0.1, 0.4]
[material.lamp]
emission = [0.9, 0.6, 0.3]
colour = [0.0, 0.0, 0.0]
light = true
[[light]]
kind = "ambient"
ambient = [0.2, 0.2, 0.25]
[[light]]
kind = "directional"
direction = [1.0, -1.5, -0.8]
diffuse = [0.6, 0.6, 0.5]
[[light]]
kind = "point"
position = [-1.0, 3.0, 3.0]
diffuse = [0.8, 0.8, 0.8]
attenuation = [1.0, 0.0, 0.1]
[[plane]]
point = [0.2, 0.0, 0.1]
normal = [0.0, 1.0, 0.0]
material = "floor"
[[rectangle]]
corner = [-1.9, 0.2, -1.4]
edge_u = [2.4, 0.0, -0.4]
edge_v = [0.3, 1.6, -0.1]
material = "mirror"
[[triangle]]
a = [-2.0, 0.0, 0.4]
b = [-1.0, 0.0, 0.6]
c = [-1.6, 1.1, 0.1]
material = "red"
[[disk]]
centre = [1.4, 1.3, -0.9]
normal = [-0.3, 0.2, 1.0]
radius = 0.7
material = "red"
[[cylinder]]
base = [1.5, 0.0, 0.3]
axis = [0.2, 0.7, 0.0]
radius = 0.35
capped = true
material = "blue"
[[cylinder]]
base = [0.2, 0.0, -0.3]
axis = [0.0, 0.5, 0.3]
radius = 0.4
material = "blue"
[[sphere]]
centre = [0.7, 0.4, 1.3]
radius = 0.4
material = "mirror"
[[sphere]]
centre = [-0.5, 0.5, 1.2]
radius = 0.5
material = "glass"
[[sphere]]
centre = [0.15, 0.15, 1.9]
radius = 0.15
material = "lamp"
)";

class PlainTracer : public test::InAFolder
{
protected:
    // A binary PPM as it is written: no comments, 255 for white. The top row comes first.
    Picture ppm(const std::string& name, int width, int height) const
    {
        const std::string bytes = readFile(folder / name);
        const std::string header = "P6\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n";
        Picture picture{width, height, PixelFormat::srgb8, {}, {}};
        if (bytes.rfind(header, 0) != 0 ||
            bytes.size() != header.size() + static_cast<std::size_t>(3 * width * height))
            throw std::runtime_error(name + " is not that picture");
        for (int y = height - 1; y >= 0; --y)
            for (int x = 0; x < width; ++x) {
                const char* rgb = bytes.data() + header.size() + 3 * (y * width + x);
                picture.bytes.insert(picture.bytes.end(), rgb, rgb + 3);
                picture.bytes.push_back(255);
            }
        return picture;
    }
};

} // namespace

TEST_F(PlainTracer, EveryKindOfSurface_LooksAsDioptreDrawsIt)
{
    writeFile(folder / "scene.toml", everything);
    const auto plain = here(tracer + "scene.toml 96 72 1 -o a.ppm");
    ASSERT_EQ(plain.code, 0) << plain.error;
    const auto drawn = here("dioptre render scene.toml --size 96x72 --spp 1 -o a.png");
    ASSERT_EQ(drawn.code, 0) << drawn.error;
    const auto difference = test::compareEncoded(test::decoded(ppm("a.ppm", 96, 72)),
                                                 test::decoded(readPicture(folder / "a.png")), 3.0);
    // It ends after five bounces, and single precision moves edges: on at most one pixel in two hundred.
    std::cout << difference.over << " of " << difference.pixels << " pixels over 3 of 255\n";
    EXPECT_LE(difference.over, difference.pixels / 200);
}

TEST_F(PlainTracer, StillLife_HasItsObjectsInTheirPlaces)
{
    const auto outcome = here(tracer + stillLife + "400 400 8 -o a.ppm");
    ASSERT_EQ(outcome.code, 0) << outcome.error;
    const auto picture = ppm("a.ppm", 50, 50);
    // Of the pixel of the whole picture, from its upper left corner, as dioptre's own picture of 400x400
    // shows it.
    const auto at = [&](int x, int y) {
        const auto first = picture.bytes.begin() + 4 * ((49 - y / 8) * 50 + x / 8);
        return std::array<int, 3>{first[0], first[1], first[2]};
    };
    const auto sky = at(200, 20), triangle = at(4, 316), disk = at(316, 140), cylinder = at(364, 230);
    EXPECT_GT(sky[2], sky[0]);
    EXPECT_GT(triangle[0], 2 * std::max(triangle[1], triangle[2]));
    EXPECT_GT(disk[1], disk[0] + 20);
    EXPECT_GT(cylinder[2], cylinder[0] + 60);
    const auto frame = at(100, 58), shadow = at(364, 290);
    EXPECT_LT(*std::max_element(frame.begin(), frame.end()), 60);
    EXPECT_GT(cylinder[2], shadow[2] + 40) << "it lies partly in shadow";
}

TEST_F(PlainTracer, Json_ScalesTheTimeToAllPixels)
{
    const auto json = nlohmann::json::parse(here(tracer + stillLife + "40 30 10").out);
    EXPECT_EQ(json["pixels"], 12);
    const double seconds = json["seconds"];
    EXPECT_GT(seconds, 0.0);
    EXPECT_NEAR(json["scaled_seconds"], 100.0 * seconds, 1e-9 * seconds);
}

TEST_F(PlainTracer, WithoutItsScene_SaysSo)
{
    const auto outcome = here(tracer + "nowhere.toml 4 4 1");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.error.find("nowhere.toml"), std::string::npos) << outcome.error;
}
