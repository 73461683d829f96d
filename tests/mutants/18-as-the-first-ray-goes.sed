# file: trace/scatter.glsl
# answer: 18-a-ray-that-a-mirror-turned
# Defect 18 as it was: the surface's outer side is compared with the direction in which the eye looks.
s/hit\.inside ? material\.bending/dot(hit.inside ? -surface.normal : surface.normal, u_camera.forward.xyz) > 0.0 ? material.bending/
