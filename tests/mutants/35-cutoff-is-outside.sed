# file: trace/light.glsl
# answer: 34-spot-cutoff
# Defect 35: the edge of the cone does not count as inside.
s/cosine >= light\.direction\.w/cosine > light.direction.w/
