# file: kernel/dielectric.glsl
# answer: 15-fresnel-averages-both-polarisations
# Defect 15: only the perpendicular polarisation counts.
s/0\.5 \* perpendicular \* perpendicular \* (1\.0 + ratio \* ratio)/perpendicular * perpendicular/
