// Variables that nobody set are 0, as browsers make them.
// expect: 0,0 = 0.25 0.5 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    float sum;
    vec3 colour;
    for (int i = 0; i < 4; i++)
        sum += 0.0625;
    colour.y += 0.5;
    fragColor = vec4(sum + colour.x, colour.y, colour.z, 1.0);
}
