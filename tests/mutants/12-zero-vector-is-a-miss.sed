# file: trace/scatter.glsl
# answer: 12-a-hit-at-the-worlds-origin
# Defect 12: the point (0, 0, 0) stands for a miss.
s/bool missed = hit\.object < 0;/bool missed = hit.object < 0 || path.ray.origin + hit.t * path.ray.direction == vec3(0.0);/
