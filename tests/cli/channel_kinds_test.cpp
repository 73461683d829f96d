// What a file holds decides how it is read, and not its name; and where the faces of a cube lie.
#include "base/picture.h"
#include "support/forged_pictures.h"
#include "support/in_a_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

class ChannelKinds : public InAFolder
{
protected:
    void shader(const std::string& name, const std::string& expression, const std::string& before = "")
    {
        std::ofstream(folder / name) << before
                                     << "void mainImage(out vec4 o, in vec2 p)\n{\n    o = " << expression
                                     << ";\n}\n";
    }

    Picture drawn(const std::string& command)
    {
        const auto outcome = here("dioptre render " + command + " -o out.exr");
        EXPECT_EQ(outcome.code, 0) << outcome.error;
        return readPicture(folder / "out.exr");
    }
};

} // namespace

TEST_F(ChannelKinds, ContentUnderAnotherName_IsReadAsWhatItIs)
{
    std::ofstream(folder / "jpeg.png", std::ios::binary) << greyJpeg();
    shader("quarter.frag", "vec4(0.25, 0.5, 2.0, 1.0)");
    ASSERT_EQ(here("dioptre render quarter.frag --size 8x8 -o a.png && mv a.png png.jpg && "
                   "dioptre render quarter.frag --size 8x8 -o a.exr && mv a.exr exr.hdr && "
                   "dioptre render quarter.frag --size 8x8 -o a.hdr && mv a.hdr hdr.exr")
                  .code,
              0);
    shader("p.frag", "texture(iChannel0, p / iResolution.xy)");
    const double byte = 1.0 / 255.0;
    struct Row {
        std::string file;
        std::array<double, 3> asChannel; // bytes as they stand
        std::array<double, 3> asSky;     // bytes decoded from sRGB
    };
    const auto decoded = [](double encoded) { return std::pow((encoded + 0.055) / 1.055, 2.4); };
    for (const Row& row : {Row{"jpeg.png", {192 * byte, 192 * byte, 192 * byte}, {}},
                           Row{"png.jpg", {64 * byte, 128 * byte, 1.0}, {}},
                           Row{"exr.hdr", {0.25, 0.5, 2.0}, {0.25, 0.5, 2.0}},
                           Row{"hdr.exr", {0.25, 0.5, 2.0}, {0.25, 0.5, 2.0}}}) {
        SCOPED_TRACE(row.file);
        const auto channel = drawn("p.frag --size 4x4 --channel0 " + row.file);
        std::ofstream(folder / "sky.toml") << "[sky]\nimage = \"" << row.file << "\"\n";
        const auto sky = drawn("sky.toml --size 4x4 --spp 1");
        // Lit by 1 and nothing else, a surface shows its picture. It fills the view.
        std::ofstream(folder / "wall.toml")
            << "[camera]\neye = [0, 0, 1]\ntarget = [0, 0, 0]\n[material.m]\nimage = \"" << row.file
            << "\"\n[[light]]\nkind = \"ambient\"\nambient = [1, 1, 1]\n"
               "[[rectangle]]\ncorner = [-9, -9, 0]\nedge_u = [18, 0, 0]\nedge_v = [0, 18, 0]\nmaterial = "
               "\"m\"\n";
        const auto wall = drawn("wall.toml --size 4x4 --spp 1");
        for (std::size_t c = 0; c < 3; ++c) {
            const double light = row.asSky[2] > 0.0 ? row.asSky[c] : decoded(row.asChannel[c]);
            EXPECT_NEAR(channel.floats[c], row.asChannel[c], 1e-5) << "channel " << c;
            EXPECT_NEAR(sky.floats[c], light, 1e-3) << "sky " << c;
            EXPECT_NEAR(wall.floats[c], light, 1e-3) << "wall " << c;
        }
    }
}

namespace
{

struct Direction {
    double x, y, z;
};

// OpenGL 3.3, table 3.19: the face that a direction meets, and where: s = (sc / |ma| + 1) / 2, t likewise.
struct CubeTexel {
    int face; // +x -x +y -y +z -z
    double s;
    double t;
};

CubeTexel specified(const Direction& r)
{
    const double x = std::abs(r.x), y = std::abs(r.y), z = std::abs(r.z);
    int face = 0;
    double sc = 0.0, tc = 0.0, ma = 0.0;
    if (x > y && x > z) {
        face = r.x > 0.0 ? 0 : 1;
        sc = r.x > 0.0 ? -r.z : r.z;
        tc = -r.y;
        ma = x;
    } else if (y > z) {
        face = r.y > 0.0 ? 2 : 3;
        sc = r.x;
        tc = r.y > 0.0 ? r.z : -r.z;
        ma = y;
    } else {
        face = r.z > 0.0 ? 4 : 5;
        sc = r.z > 0.0 ? r.x : -r.x;
        tc = -r.y;
        ma = z;
    }
    return {face, (sc / ma + 1.0) / 2.0, (tc / ma + 1.0) / 2.0};
}

// Four to a face, one in each of its quarters, none near an edge.
std::vector<Direction> directions()
{
    std::vector<Direction> all;
    for (const double main : {1.0, -1.0})
        for (const double a : {0.4, -0.7})
            for (const double b : {0.6, -0.3}) {
                all.push_back({main, a, b});
                all.push_back({a, main, b});
                all.push_back({a, b, main});
            }
    return all;
}

// A face as an upright picture: red tells which it is, green its right half, blue its lower half.
std::string faceAt(const std::string& face, const std::string& right, const std::string& down)
{
    return "vec4((" + face + " + 1.0) / 8.0, step(0.5, " + right + "), step(0.5, " + down + "), 1.0)";
}

class CubeFaces : public ChannelKinds
{
protected:
    CubeFaces()
    {
        for (int face = 0; face < 6; ++face) {
            const std::string name = "face" + std::to_string(face);
            shader(name + ".frag", faceAt(std::to_string(face) + ".0", "p.x / 4.0", "1.0 - p.y / 4.0"));
            here("dioptre render " + name + ".frag --size 4x4 -o " + name + ".exr");
        }
        std::string text = "const vec3 directions[24] = vec3[24](";
        for (const auto& r : directions())
            text += (text.ends_with('(') ? "vec3(" : ", vec3(") + std::to_string(r.x) + ", " +
                    std::to_string(r.y) + ", " + std::to_string(r.z) + ")";
        shader("p.frag", "textureLod(iChannel0, directions[int(p.x)], 0.0)", text + ");\n");
    }

    void expectFaces(const std::string& channel, bool turned = false)
    {
        SCOPED_TRACE(channel);
        const auto picture = drawn("p.frag --size 24x1 --channel0 '" + channel + "'");
        const auto all = directions();
        for (std::size_t i = 0; i < all.size(); ++i) {
            const CubeTexel texel = specified(all[i]);
            SCOPED_TRACE(testing::Message() << all[i].x << ", " << all[i].y << ", " << all[i].z);
            EXPECT_NEAR(picture.floats[4 * i], (texel.face + 1.0) / 8.0, 1e-3);
            EXPECT_EQ(picture.floats[4 * i + 1], texel.s > 0.5 ? 1.0F : 0.0F);
            EXPECT_EQ(picture.floats[4 * i + 2], (texel.t > 0.5) != turned ? 1.0F : 0.0F);
        }
    }

    const std::string six = "face0.exr,face1.exr,face2.exr,face3.exr,face4.exr,face5.exr?filter=nearest";
};

} // namespace

// The site uploads faces as they stand, the top row first.
TEST_F(CubeFaces, SixFiles_LieAsOpenGlSays)
{
    expectFaces(six);
    expectFaces(six + "&flip=no");
}

TEST_F(CubeFaces, Flipped_HaveTheirLowestRowAtZero)
{
    expectFaces(six + "&flip=yes", true);
}

// -x +z +x -z in the middle row, +y above and -y below the second.
TEST_F(CubeFaces, WideCross_LiesAsOpenGlSays)
{
    shader(
        "wide.frag",
        faceAt("faces[3 * int(p.x / 4.0) + int(3.0 - p.y / 4.0)]", "fract(p.x / 4.0)",
               "1.0 - fract(p.y / 4.0)"),
        "const float faces[12] = float[12](9.0, 1.0, 9.0, 2.0, 4.0, 3.0, 9.0, 0.0, 9.0, 9.0, 5.0, 9.0);\n");
    ASSERT_EQ(here("dioptre render wide.frag --size 16x12 -o wide.exr").code, 0);
    expectFaces("wide.exr?cube&filter=nearest");
}

// -x +z +x in the second row, +y above, -y below the middle, and -z under it upside down.
TEST_F(CubeFaces, TallCross_LiesAsOpenGlSays)
{
    shader(
        "tall.frag",
        "p.y < 4.0 ? " + faceAt("5.0", "1.0 - fract(p.x / 4.0)", "fract(p.y / 4.0)") + " : " +
            faceAt("faces[4 * int(p.x / 4.0) + int(4.0 - p.y / 4.0)]", "fract(p.x / 4.0)",
                   "1.0 - fract(p.y / 4.0)"),
        "const float faces[12] = float[12](9.0, 1.0, 9.0, 9.0, 2.0, 4.0, 3.0, 5.0, 9.0, 0.0, 9.0, 9.0);\n");
    ASSERT_EQ(here("dioptre render tall.frag --size 12x16 -o tall.exr").code, 0);
    expectFaces("tall.exr?cube&filter=nearest");
}
