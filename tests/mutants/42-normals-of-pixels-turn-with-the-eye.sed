# file: raster/surface.frag
# answer: 42-a-turned-view-lights-alike
# Defect 42: the normal is taken to the eye's frame, and the lights are not.
s/surface\.normal = u_side \* outward;/surface.normal = u_side * normalize(vec3(dot(outward, u_camera.right.xyz), dot(outward, u_camera.up.xyz), -dot(outward, u_camera.forward.xyz)));/
