# file: kernel/lobe.glsl
# answer: 38-no-highlight-behind-the-reflection
# Defect 38: an even power of a negative cosine shines.
s/return dot(a, b) > 0\.0 ? power : 0\.0;/return max(power, 0.0);/
