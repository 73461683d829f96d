# file: kernel/dielectric.glsl
# answer: 20-tangent-to-an-unseen-ball
# Defect 20: 0/0 where indices are equal and the ray only touches.
s/return m == 0\.0 ? 0\.0 : (gg <= 0\.0 ? 1\.0 : reflectance);/return m != 0.0 \&\& gg <= 0.0 ? 1.0 : reflectance;/
