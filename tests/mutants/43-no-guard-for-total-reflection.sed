# file: kernel/dielectric.glsl
# answer: 17-total-internal-reflection
# Defect 43: the formula is used beyond the critical angle.
s/float g = sqrt(max(gg, 0\.0));/float g = sqrt(gg);/
s/(gg <= 0\.0 ? 1\.0 : reflectance)/reflectance/
