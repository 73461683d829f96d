#include "raster/sample_target.h"

#include "base/error.h"
#include "gl/texture_binding.h"

#include <fmt/format.h>

namespace dioptre
{
namespace
{

Texture newTexture(GLenum kind)
{
    GLuint name = 0;
    glGenTextures(1, &name);
    const TextureBinding binding(kind, name);
    glTexParameteri(kind, GL_TEXTURE_MAX_LEVEL, 0); // complete without mip levels
    glTexParameteri(kind, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(kind, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return Texture(name);
}

Framebuffer newFramebuffer()
{
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return Framebuffer(name);
}

void refuseWithoutMemory(const std::string& what, const std::string& mend)
{
    if (glGetError() == GL_OUT_OF_MEMORY)
        fail(ExitCode::retry, "the driver has no memory for " + what, mend);
}

Texture depthTexture(int width, int height)
{
    Texture depth = newTexture(GL_TEXTURE_2D);
    const TextureBinding binding(GL_TEXTURE_2D, depth.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    return depth;
}

void refuseIncomplete()
{
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        fail(ExitCode::noOpenGl, "this OpenGL cannot rasterise into float32 textures",
             "try another --backend, or --method trace");
}

} // namespace

SampleTarget makeSampleTarget(int width, int height)
{
    while (glGetError() != GL_NO_ERROR) {
    }
    SampleTarget target{width, height, newTexture(GL_TEXTURE_2D), depthTexture(width, height),
                        newFramebuffer()};
    {
        const TextureBinding binding(GL_TEXTURE_2D, target.colour.name());
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, width, height, 0, GL_RGBA, GL_FLOAT, nullptr);
    }
    refuseWithoutMemory(fmt::format("{}x{} pixels", width, height), "draw a smaller --size");
    glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.colour.name(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, target.depth.name(), 0);
    refuseIncomplete();
    return target;
}

ShadowMaps makeShadowMaps(int side, int layers)
{
    const std::string mend = "set raster.shadow_map to less, or light the scene by fewer lights";
    GLint mostLayers = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &mostLayers);
    const double mebibytes = 4.0 * side * side * layers / (1024.0 * 1024.0);
    if (layers > mostLayers || mebibytes > 1024.0)
        fail(ExitCode::badInput,
             fmt::format("{} shadow maps of {}x{} texels take {:.0f} MiB, of which 1024 are the most", layers,
                         side, side, mebibytes),
             mend);
    while (glGetError() != GL_NO_ERROR) {
    }
    ShadowMaps maps{side, layers, newTexture(GL_TEXTURE_2D_ARRAY), depthTexture(side, side),
                    newFramebuffer()};
    {
        const TextureBinding binding(GL_TEXTURE_2D_ARRAY, maps.distances.name());
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, side, side, layers, 0, GL_RED, GL_FLOAT, nullptr);
    }
    refuseWithoutMemory("the shadow maps", mend);
    glBindFramebuffer(GL_FRAMEBUFFER, maps.framebuffer.name());
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, maps.distances.name(), 0, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, maps.depth.name(), 0);
    refuseIncomplete();
    return maps;
}

} // namespace dioptre
