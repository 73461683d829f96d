# file: trace/light.glsl
# answer: 34-spot-cutoff
# Defect 35: the edge of the cone does not count as inside.
s/dot(chord, chord) <= light\.direction\.w/dot(chord, chord) < light.direction.w/
