# file: trace/depth_first.glsl
# answer: 17-a-ray-of-no-weight-takes-no-place
# Defect 23: what lies beyond 4 rays is dropped, depth first.
s/traced < u_budget/traced < min(u_budget, 4)/
