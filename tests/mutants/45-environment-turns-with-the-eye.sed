# file: trace/scatter.glsl
# answer: 45-a-mirror-ball-in-its-surroundings
# Defect 45: the surroundings are looked up in the eye's frame, so that they always show the same face.
s/skyRadiance(path\.ray\.direction)/skyRadiance(vec3(dot(path.ray.direction, u_camera.right.xyz), dot(path.ray.direction, u_camera.up.xyz), -dot(path.ray.direction, u_camera.forward.xyz)))/
