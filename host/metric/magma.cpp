#include "metric/magma.h"

#include <array>

namespace dioptre
{

glm::dvec3 magma(double share)
{
    static const std::array<glm::dvec3, 7> coefficients{
        glm::dvec3(-0.002136485053939582, -0.000749655052795221, -0.005386127855323933),
        glm::dvec3(0.2516605407371642, 0.6775232436837668, 2.494026599312351),
        glm::dvec3(8.353717279216625, -3.577719514958484, 0.3144679030132573),
        glm::dvec3(-27.66873308576866, 14.26473078096533, -13.64921318813922),
        glm::dvec3(52.17613981234068, -27.94360607168351, 12.94416944238394),
        glm::dvec3(-50.76852536473588, 29.04658282127291, 4.23415299384598),
        glm::dvec3(18.65570506591883, -11.48977351997711, -5.601961508734096)};
    const double x = glm::clamp(share, 0.0, 1.0);
    glm::dvec3 colour(0.0);
    for (auto coefficient = coefficients.rbegin(); coefficient != coefficients.rend(); ++coefficient)
        colour = colour * x + *coefficient; // Horner
    return glm::clamp(colour, 0.0, 1.0);
}

} // namespace dioptre
