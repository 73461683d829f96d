# file: trace/surface.glsl
# answer: 32-srgb-of-pictures
# Defect 32 on the way in: the decoding of a picture is undone.
s/colour \*= pictureColour(/colour *= pow(pictureColour(/
s/^\( *footprint_m \/ coordinates\.extent\));/\1), vec3(1.0 \/ 2.2));/
