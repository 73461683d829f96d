# file: trace/scatter.glsl
# answer: 27-ambient-light-once
# Defect 27: ambient light is added once per light, and never without one.
s/radiance += u_ambient \*/radiance += float(LIGHT_COUNT) * u_ambient */
