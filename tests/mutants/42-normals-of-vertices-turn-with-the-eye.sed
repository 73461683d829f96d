# file: raster/surface.vert
# answer: 42-a-turned-view-lights-alike
# Defect 42, of light at the vertices.
s/u_side \* normalize(v_outward)/u_side * normalize(vec3(dot(v_outward, u_camera.right.xyz), dot(v_outward, u_camera.up.xyz), -dot(v_outward, u_camera.forward.xyz)))/
