# file: trace/depth_first.glsl
# answer: 18-two-glass-balls-behind-each-other
# Defect 19: the stack has 4 places, and more are written.
s/Path stack\[QUEUE_SLOTS\]/Path stack[4]/
