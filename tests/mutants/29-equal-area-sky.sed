# file: kernel/lat_long.glsl
# answer: 29-sky-directions
# Defect 29: an equal-area formula reads an equirectangular picture.
s/0\.5 + arctangent(direction\.y, ring) \/ PI/0.5 + 0.5 * direction.y \/ length(direction)/
