# file: trace/camera.glsl
# answer: 31-wide-picture
# Defect 31: the view of a picture that is not square is not centred.
s/(2\.0 \* point_px - u_resolution) \/ u_resolution\.y/(2.0 * point_px - u_resolution.yy) \/ u_resolution.y/
