# file: trace/scatter.glsl
# answer: 22-glass-that-is-half-a-mirror
# Defect 22: a refractive surface ignores its mirror coefficient.
s/reflection += passing \* reflectance;/reflection = passing > 0.0 ? vec3(material.shadow_absorption.w * reflectance) : reflection;/
s/^    float passing = .*/    float passing = material.shadow_absorption.w;/
