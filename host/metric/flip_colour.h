// The colour spaces of FLIP: Andersson et al., "FLIP: A Difference Evaluator for Alternating Images",
// Proceedings of the ACM on Computer Graphics and Interactive Techniques 3 (2), 2020; section 4.1.
#pragma once

#include <glm/glm.hpp>

namespace dioptre
{

// CIE XYZ over that of white, so that (1, 1, 1) is white; linear in linear RGB of BT.709's primaries and D65
// at (0.31271, 0.32902).
glm::dvec3 whiteRelativeXyz(const glm::dvec3& linearRgb);

// YyCxCz, the linear opponent space in which the eye's filters act: 116 y - 16, 500 (x - y), 200 (y - z) of
// white-relative x, y, z.
glm::dvec3 opponentFromRgb(const glm::dvec3& linearRgb);
glm::dvec3 rgbFromOpponent(const glm::dvec3& opponent);

// CIE L*a*b* with a* and b* scaled by 0.01 L*: colours of dark things look paler (the Hunt effect).
glm::dvec3 huntLabFromRgb(const glm::dvec3& linearRgb);

// |L1 - L2| + |(a1, b1) - (a2, b2)|: Abasi, Amani Tehran and Fairchild, 2019. Good for large differences too.
double hyab(const glm::dvec3& some, const glm::dvec3& other);

// The difference of two colours that the eye's filters have passed, in 0..1: HyAB to the power 0.7,
// stretched so that 0.4 of the largest difference, of green and blue, is 0.95 (section 4.1.3). Linear RGB in
// 0..1.
double colourDifference(const glm::dvec3& some, const glm::dvec3& other);

} // namespace dioptre
