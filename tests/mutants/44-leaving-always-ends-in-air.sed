# file: trace/scatter.glsl
# answer: 44-bubble-in-tinted-glass
# Defect 44: the medium behind an exit is taken for air.
s/hit\.inside ? int(material\.absorption\.w) : mediumOf/hit.inside ? -1 : mediumOf/
