# file: kernel/flat.glsl
# answer: 08-no-leak-along-a-shared-edge
# Defect 8: a ray through the edge that two triangles share misses both.
s/bool within = .*/bool within = (u > 0.0 \&\& v > 0.0 \&\& w > 0.0) || (u < 0.0 \&\& v < 0.0 \&\& w < 0.0);/
