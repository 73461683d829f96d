# file: trace/surface.glsl
# answer: 30-no-seam-on-a-sphere
# Defect 30: the level of detail by differences of neighbouring pixels, which jump where u wraps.
s/footprint_m \/ coordinates\.extent/fwidth(coordinates.picture)/
