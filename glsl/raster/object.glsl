// The object that is drawn, one at a time: what the scene's table tells of it where rays ask.

layout(std140) uniform ObjectBlock
{
    Shape u_shape;
    Material u_material;
    vec4 u_kind; // x
};

Shape drawnShape()
{
    return u_shape;
}

int drawnKind()
{
    return int(u_kind.x);
}

Material drawnMaterial()
{
    return u_material;
}
