# file: kernel/lat_long.glsl
# answer: 29-sky-is-linear-in-the-elevation
# Defect 29: the elevation is read as if the direction's level part were a unit vector.
s/arctangent(direction\.y, ring)/arctangent(direction.y, 1.0)/
