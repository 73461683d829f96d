// Six faces: red towards +x, blue towards -x, green towards +y, black elsewhere.
// options: --channel0 'red.png,blue.png,green.png,black.png,black.png,black.png?filter=nearest'
// expect: 0,0 = 1 0 0
// expect: 3,0 = 0 0 1
// expect: 6,0 = 0 1 0
// expect: 7,0 = 0 0 0
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec3 direction = fragCoord.x < 3.0 ? vec3(1.0, 0.2, 0.1)
                   : fragCoord.x < 6.0 ? vec3(-1.0, 0.2, 0.1)
                   : fragCoord.x < 7.0 ? vec3(0.3, 1.0, 0.1) : vec3(0.3, 0.2, -1.0);
    fragColor = texture(iChannel0, direction);
}
