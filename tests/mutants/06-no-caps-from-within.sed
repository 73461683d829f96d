# file: kernel/cylinder.glsl
# answer: 06-caps-from-inside
# Defect 6 from within: the far end of the span must be the side's.
s/span\.found = side\.found && slab\.found && span\.near <= span\.far;/span.found = side.found \&\& slab.found \&\& span.near <= span.far \&\& span.far == side.far;/
