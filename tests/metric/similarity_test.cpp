// PSNR and SSIM where their values can be worked out.
#include "metric/psnr.h"
#include "metric/ssim.h"

#include "pictures.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace dioptre;
using namespace dioptre::test;

namespace
{

PicturePair grey(int width, int height, float reference, float picture)
{
    return pairOf(width, height, uniform(glm::vec3(reference)), uniform(glm::vec3(picture)));
}

glm::vec3 greyNoise(const Painter& paint, int x, int y)
{
    return glm::vec3(paint(x, y).r);
}

} // namespace

TEST(Psnr, EqualPictures_AreInfinitelyGood)
{
    EXPECT_TRUE(std::isinf(psnr_db(pairOf(5, 5, noise(1), noise(1)))));
}

TEST(Psnr, ATenthOffEverywhere_IsTwentyDecibels)
{
    EXPECT_NEAR(psnr_db(grey(4, 4, 0.5f, 0.6f)), 20.0, 1e-5); // -10 log10(0.01)
}

// One channel of one of 100 pixels off by the peak: the mean square error is 1 / 300.
TEST(Psnr, MeanRunsOverAllChannels)
{
    const auto spot = [](int x, int y) { return x == 3 && y == 4 ? glm::vec3(0, 1, 0) : glm::vec3(0); };
    EXPECT_NEAR(psnr_db(pairOf(10, 10, uniform(glm::vec3(0)), spot)), 10.0 * std::log10(300.0), 1e-9);
}

TEST(Psnr, NothingToJudge_IsUndefined)
{
    EXPECT_TRUE(std::isnan(psnr_db(grey(3, 3, NAN, 0.5f))));
}

TEST(Ssim, EqualPictures_AreOne)
{
    EXPECT_NEAR(ssim(pairOf(40, 30, noise(1), noise(1))), 1.0, 1e-12);
}

// Without variance the second factor is C2 / C2, and equation 13 is that of the means alone.
TEST(Ssim, UniformPictures_DifferByTheirMeansAlone)
{
    const double x = 0.25, y = 0.75, c1 = 1e-4;
    EXPECT_NEAR(ssim(grey(20, 20, 0.25f, 0.75f)), (2 * x * y + c1) / (x * x + y * y + c1), 1e-12);
}

// Where a window's means are equal the first factor is 1, and equation 13 is (2 c + C2) / (vx + vy + C2) with
// covariance c; of one window, 11x11, worked out here as sums over the square.
TEST(Ssim, OneWindow_IsEquationThirteen)
{
    const PicturePair pair = pairOf(11, 11, noise(1), noise(2));
    double sumW = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;
    for (int row = 0; row < 11; ++row)
        for (int column = 0; column < 11; ++column) {
            const double dx = column - 5, dy = row - 5, w = std::exp(-(dx * dx + dy * dy) / (2 * 1.5 * 1.5));
            const auto i = static_cast<std::size_t>(row * 11 + column);
            const auto luminance = [](const glm::vec3& c) {
                return 0.2126 * static_cast<double>(c.r) + 0.7152 * static_cast<double>(c.g) +
                       0.0722 * static_cast<double>(c.b);
            };
            const double a = luminance(pair.reference[i]), b = luminance(pair.picture[i]);
            sumW += w;
            x += w * a;
            y += w * b;
            xx += w * a * a;
            yy += w * b * b;
            xy += w * a * b;
        }
    for (double* mean : {&x, &y, &xx, &yy, &xy})
        *mean /= sumW;
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    EXPECT_NEAR(ssim(pair),
                (2 * x * y + c1) * (2 * (xy - x * y) + c2) /
                    ((x * x + y * y + c1) * (xx - x * x + yy - y * y + c2)),
                1e-12);
}

TEST(Ssim, ANegative_IsBelowZero)
{
    const Painter paint = noise(4);
    const PicturePair positive = pairOf(
        30, 30, [&](int x, int y) { return greyNoise(paint, x, y); }, uniform(glm::vec3(0)));
    PicturePair negative = positive;
    for (std::size_t i = 0; i < negative.picture.size(); ++i)
        negative.picture[i] = glm::vec3(1.0f) - negative.reference[i];
    EXPECT_LT(ssim(negative), -0.5); // covariance = -variance, means alike
}

TEST(Ssim, MoreNoise_IsLess)
{
    double before = 1.0;
    for (const float amount : {0.01f, 0.05f, 0.2f}) {
        const Painter grain = noise(9, amount);
        const PicturePair pair = pairOf(64, 64, noise(1, 0.8f), [&, base = noise(1, 0.8f)](int x, int y) {
            return base(x, y) + grain(x, y);
        });
        const double now = ssim(pair);
        EXPECT_LT(now, before) << amount;
        before = now;
    }
}

TEST(Ssim, PicturesSmallerThanTheWindow_AreUndefined)
{
    EXPECT_TRUE(std::isnan(ssim(grey(10, 40, 0.5f, 0.5f))));
    EXPECT_TRUE(std::isnan(ssim(grey(40, 10, 0.5f, 0.5f))));
    EXPECT_FALSE(std::isnan(ssim(grey(11, 11, 0.5f, 0.5f))));
}

// The pixel is black in both, and windows around it see no difference there.
TEST(Ssim, APixelThatIsNotFinite_DoesNotSpread)
{
    const auto holed = [paint = noise(1)](int x, int y) {
        const glm::vec3 colour = paint(x, y);
        return x == 15 && y == 15 ? glm::vec3(NAN) : colour;
    };
    EXPECT_NEAR(ssim(pairOf(31, 31, holed, noise(1))), 1.0, 1e-12);
}
