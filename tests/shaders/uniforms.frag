// Uniforms of every kind by --set; one has a value of its own.
// options: --set u_speed=0.25 --set u_count=3 --set u_turn=[0,1,-1,0] --set 'u_colours=0,0,0,0.5,0.5,0.5' --set u_on=true --set u_bits=7 --set u_tint=#ff0000
// expect: 0,0 = 0.75 0.5 0.75
uniform float u_speed, u_gain = 2.0;
uniform int u_count;
uniform mat2 u_turn;
uniform vec3 u_colours[2], u_tint;
uniform bool u_on;
uniform uint u_bits;
void mainImage(out vec4 fragColor, in vec2 fragCoord)
{
    vec2 turned = u_turn * vec2(1.0, 0.0);
    fragColor = vec4(u_speed * float(u_count), u_colours[1].y * turned.y, u_speed + u_gain / 4.0, 1.0);
    if (!u_on || u_bits != 7u || u_tint != vec3(1.0, 0.0, 0.0))
        fragColor = vec4(0.0);
}
