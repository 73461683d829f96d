# file: trace/light.glsl
# answer: 39-spot-without-a-cone
# Defect 39: the base of the spot's power is not clamped.
s/pow(max(cosine, 1\.0e-6), exponent)/pow(cosine, exponent)/
