# file: kernel/sphere.glsl
# answer: 03-far-from-the-eye
# Defect 3: the line's point nearest to the centre is formed among the places of the scene, whose steps are coarse there.
s/vec3 h = f + b \* ray\.direction;/vec3 h = (ray.origin + b * ray.direction) - centre;/
