#include "scene/primitive.h"

#include "scene/direction.h"

namespace dioptre
{

namespace
{

Primitive readSphere(const TableReader& reader)
{
    Sphere sphere;
    reader.vector("centre", sphere.centre);
    reader.number("radius", sphere.radius, aboveZero);
    return sphere;
}

Primitive readCylinder(const TableReader& reader)
{
    Cylinder cylinder;
    reader.vector("base", cylinder.base);
    reader.nonZero("axis", cylinder.axis);
    reader.number("radius", cylinder.radius, aboveZero);
    reader.flag("capped", cylinder.capped);
    return cylinder;
}

Primitive readPlane(const TableReader& reader)
{
    Plane plane;
    reader.vector("point", plane.point);
    reader.nonZero("normal", plane.normal);
    double extent_m = 0.0;
    reader.number("raster_extent_m", extent_m, aboveZero);
    if (extent_m > 0.0)
        plane.rasterExtent_m = extent_m;
    return plane;
}

Primitive readDisk(const TableReader& reader)
{
    Disk disk;
    reader.vector("centre", disk.centre);
    reader.nonZero("normal", disk.normal);
    reader.number("radius", disk.radius, aboveZero);
    return disk;
}

Primitive readRectangle(const TableReader& reader)
{
    Rectangle rectangle;
    reader.vector("corner", rectangle.corner);
    reader.nonZero("edge_u", rectangle.edgeU);
    reader.nonZero("edge_v", rectangle.edgeV);
    if (parallel(rectangle.edgeU, rectangle.edgeV))
        fail(ExitCode::badInput, reader.where("edge_v"),
             "edge_u and edge_v are parallel: no area lies between", "turn one of them");
    return rectangle;
}

Primitive readTriangle(const TableReader& reader)
{
    Triangle triangle;
    reader.vector("a", triangle.a);
    reader.vector("b", triangle.b);
    reader.vector("c", triangle.c);
    if (parallel(triangle.b - triangle.a, triangle.c - triangle.a))
        fail(ExitCode::badInput, reader.where("c"), "a, b and c lie on one line: the triangle has no area",
             "move one of them");
    return triangle;
}

} // namespace

const std::vector<PrimitiveKind>& primitiveKinds()
{
    static const std::vector<PrimitiveKind> kinds{
        {"sphere", {"centre", "radius"}, {}, readSphere},
        {"cylinder", {"base", "axis", "radius"}, {"capped"}, readCylinder},
        {"plane", {"point", "normal"}, {"raster_extent_m"}, readPlane},
        {"disk", {"centre", "normal", "radius"}, {}, readDisk},
        {"rectangle", {"corner", "edge_u", "edge_v"}, {}, readRectangle},
        {"triangle", {"a", "b", "c"}, {}, readTriangle}};
    return kinds;
}

} // namespace dioptre
