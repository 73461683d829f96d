# file: kernel/lat_long.glsl
# answer: 29-sky-is-linear-in-the-elevation
# Defect 29: the elevation is read as if the direction's level part were a unit vector.
s/atan(direction\.y, ring)/atan(direction.y, 1.0)/
