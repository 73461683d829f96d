# file: kernel/ray.glsl
# answer: 09-no-acne-on-round-shapes
# Defect 9: nothing keeps a ray from meeting the solid that it leaves.
s/ && ray\.from != 2 \* object;/;/
