// How many objects a context holds: what is made and not deleted shows.
#pragma once

namespace dioptre
{

// Programs, shaders, textures, buffers, framebuffers and vertex arrays of the current context, by asking it
// for each name from 1 on; names far beyond those in use are not looked at.
int countGlObjects();

} // namespace dioptre
