// Loops that can be told to be endless by looking at them: compilers leave out those that do nothing else,
// and no driver says so.
#pragma once

#include "render/shader_tokens.h"

namespace dioptre
{

// Throws badInput, with the place, for a for, while or do of no condition or of `true` whose body has no
// break, return, discard or macro that could hold one.
void refuseEndlessLoops(const ShaderTokens& tokens);

} // namespace dioptre
