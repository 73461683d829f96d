# file: kernel/lat_long.glsl
# answer: 29-sky-straight-up
# Defect 20: the longitude of a pole, where both arguments of the arctangent are 0.
s/ring > 0\.0 ? arctangent(direction\.x, direction\.z) : 0\.0/arctangent(direction.x, direction.z)/
