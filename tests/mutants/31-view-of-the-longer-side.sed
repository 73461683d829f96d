# file: trace/camera.glsl
# answer: 31-tall-picture
# Defect 31 as it was: the view is that of a square on the longer side, and the picture its lower left part.
s/(2\.0 \* point_px - u_resolution) \/ u_resolution\.y/2.0 * point_px \/ max(u_resolution.x, u_resolution.y) - 1.0/
