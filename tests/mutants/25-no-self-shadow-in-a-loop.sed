# file: trace/scene_loop.glsl
# answer: 04-far-wall-over-the-rim
# Defect 25: an object that is the one to be lit is not asked whether it stands in the light's way.
s/if (object == glowing || /if (object == glowing || object == ray.from \/ 2 || /
