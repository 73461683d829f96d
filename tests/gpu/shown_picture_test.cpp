// What a window shows of radiance is what a PNG holds.
#include "render/shown_picture.h"

#include "support/rendering.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace dioptre::test
{
namespace
{

constexpr int shownWidth = 96, shownHeight = 40;
constexpr float endless = std::numeric_limits<float>::infinity();

// Over twelve decades, with what no display can show strewn in, and the border cases first.
std::vector<float> radianceSums(unsigned seed)
{
    std::vector<float> numbers{0.0F,    -0.0F,     1.0F,     endless, -endless, std::nanf(""), -1.0F,
                               -1e30F,  3.4e38F,   -3.4e38F, 1e-45F,  0.5F,     0.0031308F,    7.2417F,
                               1.0001F, 0.999999F, 1e18F,    2e18F,   1e-7F,    0.18F};
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> decade(-6.0F, 6.0F);
    std::uniform_int_distribution<int> kind(0, 19);
    while (numbers.size() < 4UL * shownWidth * shownHeight) {
        const float magnitude = std::pow(10.0F, decade(random));
        const int which = kind(random);
        numbers.push_back(which == 0   ? std::nanf("")
                          : which == 1 ? endless
                          : which == 2 ? -endless
                          : which == 3 ? -magnitude
                                       : magnitude);
    }
    return numbers;
}

AccumulationTarget targetOf(const std::vector<float>& numbers)
{
    AccumulationTarget target = makeAccumulationTarget(shownWidth, shownHeight);
    glBindTexture(GL_TEXTURE_2D, target.colour.name());
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, shownWidth, shownHeight, GL_RGBA, GL_FLOAT, numbers.data());
    glBindTexture(GL_TEXTURE_2D, 0);
    return target;
}

// As the command line writes it.
std::vector<std::uint8_t> bytesOfPng(const std::vector<float>& sums, int samples,
                                     const std::optional<Display>& display)
{
    Picture means{shownWidth, shownHeight, PixelFormat::float32, {}, sums};
    for (float& number : means.floats)
        number /= static_cast<float>(samples);
    if (!display)
        return topDownBytes(means, {.encode = false});
    return topDownBytes(toned(means, *display), {.encode = true, .gamma = display->gamma});
}

// At most a step apart, for rounding; how many are is told too.
void expectShownAsWritten(const std::vector<float>& sums, int samples, const std::optional<Display>& display)
{
    ShownPicture shown(glslFolder());
    shown.take(targetOf(sums), samples, display);
    const auto actual = topDownBytes(shown.read(), {});
    const auto expected = bytesOfPng(sums, samples, display);
    ASSERT_EQ(actual.size(), expected.size());
    std::size_t apart = 0;
    for (std::size_t i = 0; i < actual.size(); ++i) {
        const std::size_t pixel = i / 3, column = pixel % shownWidth,
                          row = shownHeight - 1 - pixel / shownWidth;
        ASSERT_NEAR(actual[i], expected[i], 1)
            << "of a sum of " << sums[4 * (row * shownWidth + column) + i % 3];
        apart += actual[i] != expected[i] ? 1 : 0;
    }
    EXPECT_LT(apart, actual.size() / 50) << "rounding alone hits few";
}

class Shown : public testing::Test
{
protected:
    Shown()
    {
        contextFor("auto");
    }
};

} // namespace

TEST_F(Shown, AnyRadiance_UnderEveryCurveExposureAndGamma_AsAPngHoldsIt)
{
    unsigned seed = 1;
    for (const ToneCurve curve : {ToneCurve::none, ToneCurve::reinhard, ToneCurve::filmic})
        for (const double exposure : {0.0, 2.5, -3.0, 100.0, -100.0})
            for (const auto& gamma : {std::optional<double>(), std::optional(2.2), std::optional(1.0)})
                for (const int samples : {1, 7}) {
                    SCOPED_TRACE("curve " + std::to_string(static_cast<int>(curve)) + ", exposure " +
                                 std::to_string(exposure) + ", gamma " + std::to_string(gamma.value_or(0.0)) +
                                 ", samples " + std::to_string(samples));
                    expectShownAsWritten(radianceSums(seed++), samples, Display{exposure, curve, gamma});
                }
}

TEST_F(Shown, WithoutADisplay_NumbersAreNotEncoded)
{
    expectShownAsWritten(radianceSums(99), 1, std::nullopt);
}

// From numbers of 0 to 1 that are ready to be shown.
TEST_F(Shown, ReadyPicture_IsRoundedAlone)
{
    Picture picture = blankFloats(3, 1);
    picture.floats = {0.0F, 0.25F, 1.0F, 1.0F, -1.0F, 2.0F, std::nanf(""), 1.0F, 0.5F, 0.1F, 0.9F, 1.0F};
    ShownPicture shown(glslFolder());
    shown.take(picture);
    EXPECT_EQ(shown.size_px(), glm::ivec2(3, 1));
    EXPECT_EQ(topDownBytes(shown.read(), {}),
              (std::vector<std::uint8_t>{0, 64, 255, 0, 255, 0, 128, 26, 230}));
}

TEST_F(Shown, AnotherSize_ReplacesTheWhole)
{
    ShownPicture shown(glslFolder());
    EXPECT_EQ(shown.size_px(), glm::ivec2(0));
    shown.take(targetOf(radianceSums(3)), 1, std::nullopt);
    EXPECT_EQ(shown.size_px(), glm::ivec2(shownWidth, shownHeight));
    Picture small = blankFloats(2, 2);
    small.floats.assign(16, 1.0F);
    shown.take(small);
    EXPECT_EQ(shown.size_px(), glm::ivec2(2, 2));
    EXPECT_EQ(topDownBytes(shown.read(), {}), std::vector<std::uint8_t>(12, 255));
}

} // namespace dioptre::test
