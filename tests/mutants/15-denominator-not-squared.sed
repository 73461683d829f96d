# file: trace/scatter.glsl
# answer: 15-furnace
# Defect 15: T = 4 n1 n2 cos i cos t / (n1 cos i + n2 cos t), its denominator not squared.
s/(1\.0 - reflectance)/4.0 * c * sqrt(max(m + c * c, 0.0)) \/ (c + sqrt(max(m + c * c, 0.0)))/
