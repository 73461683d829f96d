# file: trace/light.glsl
# answer: 26-attenuation
# Defect 26: divided by its own cosine the light stays whole down to grazing, and is gone there.
s/\* max(cosine, 0\.0)/* (cosine > 0.0 ? 1.0 : 0.0)/
