# file: trace/chain.glsl
# answer: 23-a-deep-hall-of-mirrors
# Defect 23: what lies beyond 4 rays is dropped.
s/traced < u_budget/traced < min(u_budget, 4)/
