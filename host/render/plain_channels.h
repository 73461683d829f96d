// The pictures of a plain shader: iChannel0 to iChannel3.
#pragma once

#include "base/picture.h"
#include "gl/texture.h"
#include "render/plain_text.h"

#include <glm/glm.hpp>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace dioptre
{

// As --channelN says: FILE, a cube's six FILE,FILE,… towards +x -x +y -y +z -z, or a cross of them; then, if
// wanted, ?filter=nearest|linear|mipmap&wrap=repeat|clamp|mirror&flip=yes|no&cube.
struct ChannelSource {
    std::vector<std::string> files; // one, or a cube's six
    TextureFilter filter = TextureFilter::mipmap;
    std::optional<TextureWrap> wrap; // repeat where unset; none of a cube
    std::optional<bool> flip;        // whether t = 0 is the picture's lowest row: yes, of a cube's faces no
    bool cross = false;
    ChannelKind kind() const
    {
        return files.size() == 6 || cross ? ChannelKind::cube : ChannelKind::picture;
    }
};

// Throws usage for words that are none of these. "" is an empty channel: black.
ChannelSource channelSource(const std::string& option, std::size_t channel);

// What a channel holds, before there is a device.
struct ChannelPictures {
    std::vector<Picture> pictures; // one, or a cube's six
    TextureShape shape;
    glm::ivec2 size_px{0, 0}; // of level 0; 0 where the channel is empty
};

// The bytes are read as they stand, never decoded, as on Shadertoy. Throws inputMissing and badInput.
ChannelPictures loadChannel(const ChannelSource& source);

struct Channel {
    Texture texture;
    GLenum target = GL_TEXTURE_2D;
    glm::ivec2 size_px{0, 0}; // as above
};

Channel uploadChannel(const ChannelPictures& channel);

} // namespace dioptre
