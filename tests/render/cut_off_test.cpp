// The weight below which a path is cut: trace.cut_off over the brightest radiance that it may still find.
#include "render/pack.h"
#include "scene/load.h"

#include <gtest/gtest.h>

#include <unistd.h>

using namespace dioptre;

namespace
{

constexpr double asked = 1.0 / 512.0;

// A half mirror, so that paths are sent on at all; `rest` comes first.
double cutOffOf(const std::string& rest)
{
    const auto place = std::filesystem::path(DIOPTRE_SOURCE_DIR) / "glsl" / "scenes" / "text.toml";
    const Scene scene = parseScene("[camera]\neye = [0, 0, 5]\n" + rest +
                                       "[material.chrome]\nmirror = 0.5\n"
                                       "[[sphere]]\ncentre = [0, 0, 0]\nradius = 1\nmaterial = \"chrome\"\n",
                                   place, {}, 0.0, {{"/tmp"}, {}}); // its pictures
    const Plan plan = makePlan(scene);
    auto packed = pack(scene, plan, {36, 1});
    loadPictures(scene, plan, packed);
    setCutOff(scene, plan, packed);
    return packed.cutOff;
}

// A sky of 4 with every channel of the first `bright` texels of its middle row at 1000.
std::string skyWith(int bright)
{
    Picture sky{256, 128, PixelFormat::float32, {}, {}};
    sky.floats.assign(4 * 256 * 128, 4.0F);
    for (int x = 0; x < bright; ++x)
        for (std::size_t c = 0; c < 3; ++c)
            sky.floats[4 * (64 * 256 + static_cast<std::size_t>(x)) + c] = 1000.0F;
    const auto file = "/tmp/dioptre-sky-" + std::to_string(getpid()) + ".exr";
    writeExr(file, sky, ExrDepth::full, {});
    return file;
}

} // namespace

TEST(CutOff, DimScene_KeepsWhatWasAsked)
{
    EXPECT_DOUBLE_EQ(cutOffOf("[sky]\ncolour = [0.5, 0.5, 0.5]\n"), asked);
}

TEST(CutOff, BrightSkyAndBrightAmbientLight_LowerIt)
{
    EXPECT_DOUBLE_EQ(cutOffOf("[sky]\ncolour = [1, 8, 1]\n"), asked / 8.0);
    EXPECT_DOUBLE_EQ(cutOffOf("[[light]]\nkind = \"ambient\"\nambient = [2, 1, 1]\n"
                              "[[light]]\nkind = \"ambient\"\nambient = [2, 1, 1]\n"),
                     asked / 4.0);
}

TEST(CutOff, SkyPicture_CountsBy999Thousandths)
{
    // 256 x 128 texels; the middle row weighs 1 a texel and all weigh 256 * 128 * 2 / pi = 20861, a
    // thousandth 20.9.
    for (const auto& [bright, radiance] : {std::pair{20, 4.0}, std::pair{22, 1000.0}}) {
        const auto file = skyWith(bright);
        const double found = cutOffOf("[sky]\nimage = \"" + file + "\"\n");
        EXPECT_LE(found, asked / radiance) << bright;
        EXPECT_GT(found, asked / (1.005 * radiance)) << bright;
        std::filesystem::remove(file);
    }
}

TEST(CutOff, NearLight_CountsAtItsNearestSurface)
{
    // 1 m off the ball's surface, 1 / d^2: colour 9; the scene's size does not hold it off.
    EXPECT_NEAR(cutOffOf("[[light]]\nkind = \"point\"\nposition = [0, 2, 0]\ndiffuse = [9, 9, 9]\n"
                         "attenuation = [0, 0, 1]\n"),
                asked / 9.0, 1e-12);
}
