# file: kernel/flat.glsl
# answer: 11-a-tilted-disk-is-round
# Defect 11: the distance from the centre is taken along two axes that are not the disk's own.
s/dot(offset, offset) <= radius \* radius/dot(offset.xy, offset.xy) <= radius * radius/
