# file: kernel/cylinder.glsl
# answer: 06-caps-from-outside
# Defect 6: what bounds the span must be the side; rays through a cap are lost.
s/span\.found = side\.found && slab\.found && span\.near <= span\.far;/span.found = side.found \&\& slab.found \&\& span.near <= span.far \&\& span.near == side.near;/
