# file: trace/normal.glsl
# answer: 03-far-from-the-eye
# Defect 3 for the normal: the difference of two places of the scene.
s/(ray\.origin - shape\.anchor\.xyz) + hit\.t \* ray\.direction/(ray.origin + hit.t * ray.direction) - shape.anchor.xyz/
