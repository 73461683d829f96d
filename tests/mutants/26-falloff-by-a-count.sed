# file: trace/light.glsl
# answer: 26-attenuation
# Defect 26: the light is divided by the number of lights.
s/return arriving \* reflected;/return arriving * reflected \/ float(LIGHT_COUNT);/
