# file: kernel/cylinder.glsl
# answer: 04-far-wall-over-the-rim
# Defect 25: an object never shades itself.
s/(outer || inner) && ray\.from != 2 \* object;/(outer || inner) \&\& ray.from != 2 * object \&\& !startsWithin;/
