# file: trace/scatter.glsl
# answer: 17-total-internal-reflection
# Defect 17: total reflection sends on a refracted ray too, along the zero vector.
s/vec3 through = .*/bool total = m + c * c <= 0.0;\n    vec3 through = total ? vec3(0.0) : refractedDirection(path.ray.direction, surface.normal, c, eta, m);/
s/(1\.0 - reflectance)/(total ? 1.0 : 1.0 - reflectance)/
