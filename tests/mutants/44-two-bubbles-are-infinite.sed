# The factors of two bubbles in dark glass multiply to an infinity.
# file: trace/nearest.glsl
# answer: 44-two-bubbles-in-dark-glass
s/vec3(40\.0)/vec3(80.0)/
