// With main(), in the manner of The Book of Shaders.
// options: --time 2 --mouse 4,1
// expect: 2,1 = 0.3125 0.5 0.5
#ifdef GL_ES
precision mediump float;
#endif
uniform vec2 u_resolution;
uniform vec2 u_mouse;
uniform float u_time;
void main()
{
    vec2 st = gl_FragCoord.xy / u_resolution.xy;
    gl_FragColor = vec4(st.x, u_mouse.x / u_resolution.x, u_time / 4.0, 1.0);
}
