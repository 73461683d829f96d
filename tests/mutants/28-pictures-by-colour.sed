# file: trace/surface.glsl
# answer: 28-two-pictures-of-equal-colour
# Defect 28: the picture is that of the first object whose material has the same colour.
s/^\/\/ What a pattern and a picture make.*/int pictureOfColour(vec3 colour)\n{\n    int picture = -1;\n    for (int object = SHAPE_COUNT - 1; object >= 0; --object)\n        if (materialOf(object).colour.xyz == colour)\n            picture = int(materialOf(object).colour.w);\n    return picture;\n}\n\n&/
s/pictureColour(int(material\.colour\.w)/pictureColour(pictureOfColour(material.colour.xyz)/
