// `dioptre join`: tiles that were drawn apart become the picture that one machine would have drawn.
#pragma once

#include "base/error.h"

#include <string>
#include <vector>

namespace dioptre
{

struct JoinOptions {
    std::vector<std::string> parts; // pictures of `dioptre render --tile`, in any order
    std::string output;             // of their kind
    bool json = false;
};

// Gives what the process ends with, or throws Error.
ExitCode joinTiles(const JoinOptions& options);

} // namespace dioptre
