# file: kernel/cylinder.glsl
# answer: 04-far-wall-over-the-rim
# Defect 4: only the near root is kept, so the far wall is lost through an open end.
s/bool inner = (startsWithin || (side\.found && side\.far > 0\.0))/bool inner = (startsWithin || (side.found \&\& side.near <= 0.0 \&\& side.far > 0.0))/
