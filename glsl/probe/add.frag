// A colour to be added to what the target holds.

uniform vec4 u_addend;
out vec4 o_addend;

void main()
{
    o_addend = u_addend;
}
