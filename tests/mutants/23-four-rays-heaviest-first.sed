# file: trace/heaviest_first.glsl
# answer: 15-furnace-by-default
# Defect 23: what lies beyond 4 rays is dropped, heaviest first.
s/traced < u_budget/traced < min(u_budget, 4)/
