# file: trace/light.glsl
# answer: light-type-0
# Defect 24: nothing is returned where colours are shown unlit, as under light type 0: what comes is undefined, and differs
# from form to form.
s/return material\.ambient\.w > 0\.0 ? surface\.colour : material\.ambient\.xyz;/if (material.ambient.w <= 0.0)\n        return material.ambient.xyz;/
