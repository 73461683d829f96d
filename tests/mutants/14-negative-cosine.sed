# file: trace/scatter.glsl
# answer: 14-fresnel-at-normal-incidence
# Defect 14: the cosine keeps the sign of the angle between the ray and the normal.
s/float c = clamp(-dot(path\.ray\.direction, surface\.normal), 0\.0, 1\.0);/float c = dot(path.ray.direction, surface.normal);/
