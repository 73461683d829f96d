# file: trace/camera.glsl
# answer: 44-camera-in-absorbing-water
# Defect 2: the direction keeps the length that the camera gives it, and distances come in that unit.
s/^        normalize(u_camera\.forward/        (u_camera.forward/
