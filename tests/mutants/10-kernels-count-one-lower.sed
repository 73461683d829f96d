# file: trace/scene_loop.glsl
# answer: 10-flat-shapes-keep-their-kinds
# Defect 10 as it was: the codes that choose the test are one lower than those of the constants, from the plane's on.
/^Crossing crossingOf/,/^}/s/kind == KIND_\(PLANE\|DISK\|RECTANGLE\|TRIANGLE\))/kind == KIND_\1 - 1)/
