# file: trace/light.glsl
# answer: 41-a-spots-ambient-part-stays-in-its-cone
# Defect 41: a spot's ambient part takes no notice of the cone.
s/return incidence\.strength \* light\.ambient\.xyz/return light.ambient.xyz/
