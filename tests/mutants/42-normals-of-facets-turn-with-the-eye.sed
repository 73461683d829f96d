# file: raster/surface.vert
# answer: 42-a-turned-view-lights-alike
# Defect 42, of light in the facets' middles.
s/u_side \* v_facet_normal/u_side * normalize(vec3(dot(v_facet_normal, u_camera.right.xyz), dot(v_facet_normal, u_camera.up.xyz), -dot(v_facet_normal, u_camera.forward.xyz)))/
