# file: kernel/lobe.glsl
# answer: 33-blinn-on-every-kind-of-light
# Defect 37: the half vector is not normalised.
s/between \/ size/between/
