# file: shared/constants.glsl
# answer: 10-flat-shapes-keep-their-kinds
# Defect 10: the shader's codes of flat shapes are not those of the table that the host fills in.
s/KIND_DISK = 4/KIND_DISK = 5/
s/KIND_RECTANGLE = 5/KIND_RECTANGLE = 4/
