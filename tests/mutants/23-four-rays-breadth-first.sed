# file: trace/breadth_first.glsl
# answer: 18-two-glass-balls-behind-each-other
# Defect 23: what lies beyond 4 rays is dropped, breadth first.
s/traced < u_budget/traced < min(u_budget, 4)/
