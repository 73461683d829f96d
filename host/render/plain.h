// A plain shader from its file to a picture: one sample a pixel, no decoding and no encoding.
#pragma once

#include "render/plain_channels.h"
#include "render/plain_uniforms.h"
#include "render/still.h"

namespace dioptre
{

struct PlainSettings {
    std::array<ChannelSource, 4> channels;
    PlainFrame frame;
    PlainValues values; // of --set
};

// Before the context is made: uninitialised variables start as 0 on drivers that can (Mesa's), as in a
// browser.
void startVariablesAtZero();

// Draws on the current context.
Still renderPlain(const std::filesystem::path& shader, const StillSettings& settings,
                  const PlainSettings& plain);

} // namespace dioptre
