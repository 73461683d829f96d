# file: trace/scatter.glsl
# answer: 15-fresnel-averages-both-polarisations
# Defect 13 of the reflectance alone: entering takes the ratio of leaving.
s/fresnelReflectance(c, m)/fresnelReflectance(c, hit.inside ? material.bending.z : material.bending.w)/
