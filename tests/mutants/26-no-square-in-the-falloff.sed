# file: trace/light.glsl
# answer: 26-attenuation
# Defect 26: the falloff is not what the light says.
s/(light\.attenuation\.y + d \* light\.attenuation\.z)/light.attenuation.y/
