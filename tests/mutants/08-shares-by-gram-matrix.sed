# file: kernel/flat.glsl
# answer: 08-no-leak-along-a-long-edge
# Defect 8 as it was: shares of two edges by their Gram matrix, whose rounding differs between neighbours.
s/^    crossing\.found = crossing\.found && within;/    vec3 place = ray.origin + crossing.t * ray.direction - a;\n    vec3 p = b - a;\n    vec3 q = c - a;\n    float pq = dot(p, q);\n    vec3 gram = vec3(dot(q, q) * dot(place, p) - pq * dot(place, q), dot(p, p) * dot(place, q) - pq * dot(place, p), dot(p, p) * dot(q, q) - pq * pq);\n    vec2 shares = gram.xy \/ gram.z;\n    crossing.found = crossing.found \&\& shares.x >= 0.0 \&\& shares.y >= 0.0 \&\& shares.x + shares.y <= 1.0;/
