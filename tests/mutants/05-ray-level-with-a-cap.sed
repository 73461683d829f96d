# file: kernel/cylinder.glsl
# answer: 05-ray-level-with-a-cap
# Defect 5 for the caps: 0/0 for a ray within the plane of one.
s/bool parallel = dz == 0\.0;/bool parallel = false;/
