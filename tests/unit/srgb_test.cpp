#include "base/picture.h"
#include "base/srgb.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

namespace dioptre
{
namespace
{

// IEC 61966-2-1, rounded to nearest: the judge of the table.
int codeByDefinition(float linear)
{
    const double value = linear;
    const double encoded = value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1.0 / 2.4) - 0.055;
    return static_cast<int>(std::floor(encoded * 255.0 + 0.5));
}

// Both are monotone, so agreement on either side of each of the 255 steps is agreement everywhere.
TEST(Srgb, Encode_OnEitherSideOfEveryStep_IsTheDefinition)
{
    for (int code = 1; code <= 255; ++code) {
        std::uint32_t below = 0, reached = std::bit_cast<std::uint32_t>(1.0f);
        while (reached - below > 1) {
            const std::uint32_t middle = (below + reached) / 2;
            (codeByDefinition(std::bit_cast<float>(middle)) < code ? below : reached) = middle;
        }
        EXPECT_EQ(srgb8FromLinear(std::bit_cast<float>(reached)), code);
        EXPECT_EQ(srgb8FromLinear(std::bit_cast<float>(below)), code - 1);
    }
}

// Every 1009th float of 0..1: about a million, and every cell of a table by exponent and seven bits is met 64
// times.
TEST(Srgb, Encode_ThroughoutTheUnitRange_IsTheDefinition)
{
    for (std::uint32_t bits = 0; bits <= std::bit_cast<std::uint32_t>(1.0f); bits += 1009) {
        const float linear = std::bit_cast<float>(bits);
        ASSERT_EQ(srgb8FromLinear(linear), codeByDefinition(linear)) << linear;
    }
}

TEST(Srgb, Encode_OutsideTheUnitRange_IsClamped)
{
    EXPECT_EQ(srgb8FromLinear(-0.0f), 0);
    EXPECT_EQ(srgb8FromLinear(-5.0f), 0);
    EXPECT_EQ(srgb8FromLinear(1.0f), 255);
    EXPECT_EQ(srgb8FromLinear(1e30f), 255);
    EXPECT_EQ(srgb8FromLinear(std::numeric_limits<float>::infinity()), 255);
    EXPECT_EQ(srgb8FromLinear(-std::numeric_limits<float>::infinity()), 0);
    EXPECT_EQ(srgb8FromLinear(std::numeric_limits<float>::quiet_NaN()), 0);
    EXPECT_EQ(srgb8FromLinear(std::numeric_limits<float>::denorm_min()), 0);
}

TEST(Srgb, Decode_IsUndoneByEncode)
{
    for (int code = 0; code < 256; ++code)
        EXPECT_EQ(srgb8FromLinear(linearFromSrgb8(static_cast<std::uint8_t>(code))), code);
}

// 188/255 decodes to ((0.737255 + 0.055) / 1.055)^2.4 = 0.502886; 10/255 to 0.0392157 / 12.92 = 0.00303527.
TEST(Srgb, Decode_OfKnownCodes)
{
    EXPECT_EQ(linearFromSrgb8(0), 0.0f);
    EXPECT_EQ(linearFromSrgb8(255), 1.0f);
    EXPECT_NEAR(linearFromSrgb8(188), 0.502886f, 1e-6f);
    EXPECT_NEAR(linearFromSrgb8(10), 0.00303527f, 1e-8f);
}

// The standard's two branches, which it lets meet to within 1e-7, undo each other; 0.5 is
// 1.055 * 0.5^(1/2.4) - 0.055 = 0.735357.
TEST(Srgb, Formula_IsUndoneByItsInverse_AndNeverFalls)
{
    double last = -1.0;
    for (int i = 0; i <= 4096; ++i) {
        const double encoded = srgbFromLinear(i / 4096.0);
        EXPECT_NEAR(linearFromSrgb(encoded), i / 4096.0, 1e-7);
        EXPECT_GT(encoded, last);
        last = encoded;
    }
    EXPECT_NEAR(srgbFromLinear(0.5), 0.735357, 1e-6);
    EXPECT_EQ(srgbFromLinear(0.0), 0.0);
    EXPECT_NEAR(srgbFromLinear(1.0), 1.0, 1e-15);
}

} // namespace
} // namespace dioptre
