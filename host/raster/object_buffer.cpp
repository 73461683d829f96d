#include "raster/object_buffer.h"

#include "gl/texture.h"

namespace dioptre
{
namespace
{

// Behind those that bind() hands out from 0 on.
constexpr GLuint objectBinding = 16;

template <typename Struct>
void append(std::vector<float>& values, const Struct& packed)
{
    const auto* numbers = reinterpret_cast<const double*>(&packed);
    for (std::size_t i = 0; i < sizeof(Struct) / sizeof(double); ++i)
        values.push_back(static_cast<float>(numbers[i]));
}

constexpr std::size_t bytesOfAnObject =
    (sizeof(packed::Shape) + sizeof(packed::Material) + sizeof(packed::vec4)) / sizeof(double) *
    sizeof(float);

} // namespace

std::vector<float> numbersOfObject(const PackedScene& scene, const std::vector<int>& planeOf, std::size_t id)
{
    const auto& object = scene.objects[id];
    std::vector<float> values;
    append(values, object.shape);
    append(values, scene.materials[static_cast<std::size_t>(object.material)]);
    append(values, packed::vec4(object.kind, id < planeOf.size() ? planeOf[id] : -1, 0.0, 0.0));
    return values;
}

ObjectBuffer uploadObjects(const PackedScene& scene, const std::vector<int>& planeOf)
{
    GLint alignment = 1;
    glGetIntegerv(GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const auto step = static_cast<std::size_t>(alignment);
    ObjectBuffer objects;
    objects.stride = (bytesOfAnObject + step - 1) / step * step;
    std::vector<float> values;
    for (std::size_t id = 0; id < scene.objects.size(); ++id) {
        const std::vector<float> own = numbersOfObject(scene, planeOf, id);
        values.insert(values.end(), own.begin(), own.end());
        values.resize((id + 1) * objects.stride / sizeof(float));
    }
    objects.buffer = uploadUniformBuffer(values);
    return objects;
}

void attachObjects(const Program& program)
{
    if (const auto index = program.uniformBlocks.find("ObjectBlock"); index != program.uniformBlocks.end())
        glUniformBlockBinding(program.name.name(), index->second, objectBinding);
}

void showObject(const ObjectBuffer& objects, std::size_t object)
{
    glBindBufferRange(GL_UNIFORM_BUFFER, objectBinding, objects.buffer.name(),
                      static_cast<GLintptr>(object * objects.stride),
                      static_cast<GLsizeiptr>(bytesOfAnObject));
}

} // namespace dioptre
