# file: kernel/flat.glsl
# answer: 09-no-acne-on-an-oblique-wall
# Defect 9: nothing keeps a ray from meeting the plane that it starts on.
s/crossing\.t > 0\.0 && ray\.from != 2 \* object && ray\.from != 2 \* object + 1;/crossing.t > 0.0;/
