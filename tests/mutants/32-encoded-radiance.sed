# file: ray_trace.frag
# answer: 32-srgb-in-and-out
# Defect 32 on the way out: the shader encodes what it sums, and the file's encoding comes on top. (The host encodes; no edit
# of glsl/ can take that away.)
s/o_sum = sum;/o_sum = vec4(pow(sum.xyz, vec3(1.0 \/ 2.2)), sum.w);/
