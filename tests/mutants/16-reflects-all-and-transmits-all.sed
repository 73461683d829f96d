# file: trace/scatter.glsl
# answer: 17-total-internal-reflection
# Defect 16: T = 1 where R = 1.
s/(1\.0 - reflectance)/(reflectance < 1.0 ? 1.0 - reflectance : 1.0)/
