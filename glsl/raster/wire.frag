// Of the facets' edges: one bright colour, that no exposure makes white.

out vec4 o_sample;

void main()
{
    o_sample = vec4(1.0, 0.6, 0.0, 0.0);
}
