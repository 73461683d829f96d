#include "base/tone_curve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dioptre
{
namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ToneCurve curves[] = {ToneCurve::none, ToneCurve::reinhard, ToneCurve::filmic};

TEST(ToneCurve, None_IsTheIdentityUpToWhite)
{
    for (const double x : {0.0, 1e-6, 0.25, 1.0})
        EXPECT_EQ(toned(ToneCurve::none, x), x);
    EXPECT_EQ(toned(ToneCurve::none, 7.0), 1.0);
}

// 1/2, 3/4 and 0.18/1.18.
TEST(ToneCurve, Reinhard_OfKnownRadiance)
{
    EXPECT_EQ(toned(ToneCurve::reinhard, 1.0), 0.5);
    EXPECT_EQ(toned(ToneCurve::reinhard, 3.0), 0.75);
    EXPECT_NEAR(toned(ToneCurve::reinhard, 0.18), 0.1525424, 1e-7);
}

// f(1) = 2.54 / 3.16; f(0.18) = 0.086724 / 0.324932; f = 1 where 0.08 x^2 = 0.56 x + 0.14, at 7.24166.
TEST(ToneCurve, Filmic_OfKnownRadiance)
{
    EXPECT_NEAR(toned(ToneCurve::filmic, 1.0), 0.8037975, 1e-7);
    EXPECT_NEAR(toned(ToneCurve::filmic, 0.18), 0.2668989, 1e-7);
    EXPECT_LT(toned(ToneCurve::filmic, 7.24), 1.0);
    EXPECT_EQ(toned(ToneCurve::filmic, 7.242), 1.0);
}

TEST(ToneCurve, Ends_AreBlackAndWhite_AndNaNStays)
{
    for (const ToneCurve curve : curves) {
        EXPECT_EQ(toned(curve, 0.0), 0.0);
        EXPECT_EQ(toned(curve, -3.0), 0.0);
        EXPECT_EQ(toned(curve, -infinity), 0.0);
        EXPECT_EQ(toned(curve, infinity), 1.0);
        EXPECT_TRUE(std::isnan(toned(curve, std::nan(""))));
    }
}

TEST(ToneCurve, EveryCurve_NeverFallsAndStaysInRange)
{
    for (const ToneCurve curve : curves) {
        double last = 0.0;
        for (double x = 1e-9; x < 1e9; x *= 1.01) {
            const double y = toned(curve, x);
            ASSERT_GE(y, last) << x;
            ASSERT_LE(y, 1.0) << x;
            last = y;
        }
    }
}

TEST(TonedPicture, ExposureComesBeforeTheCurve_AndAlphaStays)
{
    const Picture source{1, 1, PixelFormat::float32, {}, {0.25F, 0.75F, 0.0F, 0.5F}};
    const Picture picture = toned(source, {2.0, ToneCurve::reinhard, {}}); // x 4: 1, 3, 0
    EXPECT_EQ(picture.floats, (std::vector<float>{0.5F, 0.75F, 0.0F, 0.5F}));
    const Picture darker = toned(source, {-1.0, ToneCurve::none, {}});
    EXPECT_EQ(darker.floats, (std::vector<float>{0.125F, 0.375F, 0.0F, 0.5F}));
}

TEST(TonedPicture, ByDefault_IsTheVerySame)
{
    const Picture source{1, 1, PixelFormat::float32, {}, {4.0F, -1.0F, 0.3F, 1.0F}};
    EXPECT_EQ(toned(source, {}).floats, source.floats);
}

} // namespace
} // namespace dioptre
