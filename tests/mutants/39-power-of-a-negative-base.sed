# file: trace/light.glsl
# answer: 39-spot-without-a-cone
# Defect 39: the base of the spot's power may be negative.
s/cosinePower(light\.direction\.xyz, -towards, exponent)/pow(-dot(light.direction.xyz, towards), exponent)/
