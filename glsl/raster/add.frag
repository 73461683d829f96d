// Adds a sample of the whole picture to the sums.

uniform sampler2D u_sample;
uniform ivec2 u_sample_origin_px; // of the sums' lower left corner

out vec4 o_sum;

void main()
{
    o_sum = texelFetch(u_sample, ivec2(gl_FragCoord.xy) + u_sample_origin_px, 0);
}
