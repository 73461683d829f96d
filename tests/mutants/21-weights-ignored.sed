# file: trace/scatter.glsl
# answer: 21-a-half-mirror
# Defect 21: what a ray finds is added without its weight.
s/result\.radiance = weight \* (missed ? sky : local);/result.radiance = missed ? sky : local;/
