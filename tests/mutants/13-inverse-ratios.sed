# file: trace/scatter.glsl
# answer: 13-refraction-goes-the-right-way
# Defect 13: entering takes the ratios of leaving.
s/hit\.inside ? material\.bending/!hit.inside ? material.bending/
