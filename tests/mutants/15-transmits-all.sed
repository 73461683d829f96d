# file: trace/scatter.glsl
# answer: 15-furnace
# Defect 15: R + T is more than 1.
s/(passing \* (1\.0 - reflectance))/passing/
