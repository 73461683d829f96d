# file: kernel/lobe.glsl
# answer: 33-blinn-on-every-kind-of-light
# Defect 33: the exponent lacks the factor 4.
s/4\.0 \* shininess/shininess/
