# file: trace/scatter.glsl
# answer: 13-refraction-goes-the-right-way
# Defect 13 of the direction alone: entering takes the ratio of leaving. (Through m: eta only scales what is normalised.)
s/surface\.normal, c, eta, m);/surface.normal, c, eta, hit.inside ? material.bending.z : material.bending.w);/
