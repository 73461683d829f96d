# file: kernel/sphere.glsl
# answer: 01-camera-inside-a-sphere
# Defect 1: a hit counts only where the nearer root lies ahead.
s/^    span\.far = .*/&\n    span.found = span.found \&\& span.near > 0.0;/
