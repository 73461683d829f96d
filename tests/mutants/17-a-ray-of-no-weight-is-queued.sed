# file: trace/path.glsl
# answer: 17-a-ray-of-no-weight-takes-no-place
# Defect 17: what total reflection does not refract takes a place in the queue all the same.
s/return priority(path) > 0\.0 && /return /
