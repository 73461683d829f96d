// The object that is drawn, one at a time: what the scene's table tells of it where rays ask.

layout(std140) uniform ObjectBlock
{
    Shape u_shape;
    Material u_material;
    vec4 u_kind; // x: KIND_...; y: its place among the planes that shade, -1 for none
};

Shape drawnShape()
{
    return u_shape;
}

int drawnKind()
{
    return int(u_kind.x);
}

int drawnPlane()
{
    return int(u_kind.y);
}

Material drawnMaterial()
{
    return u_material;
}
