# file: kernel/dielectric.glsl
# answer: 17-total-internal-reflection
# Defect 16: T = 1 where R = 1.
s/gg <= 0\.0 ? 1\.0/gg <= 0.0 ? 0.0/
