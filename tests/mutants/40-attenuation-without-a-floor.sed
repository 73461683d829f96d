# file: trace/light.glsl
# answer: 20-a-light-on-the-surface
# Defect 40: 1/d^2 at d = 0.
s/max(distance, light\.specular\.w)/distance/
