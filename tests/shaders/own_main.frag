// Brings a main() of its own for another host; what counts is mainImage().
// expect: 0,0 = 0.5 0.5 0.5
precision highp float;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    fragColor = vec4(0.5);
}
void main()
{
    mainImage(gl_FragColor, gl_FragCoord.xy);
    gl_FragColor = vec4(0.0);
}
