# file: kernel/cylinder.glsl
# answer: 05-ray-parallel-to-the-axis
# Defect 5: 0/0 for a ray parallel to the axis.
s/bool parallel = mm == 0\.0;/bool parallel = mm < 0.0;/
