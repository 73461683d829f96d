# file: trace/scatter.glsl
# answer: 18-a-ray-through-two-balls
# Defect 18: whether a ray enters or leaves is not asked of the ray itself.
s/hit\.inside ? material\.bending\.[yw] : //
