// What is wrong with an edit, as a panel shows it: places, the driver's words, and the lines around them.
#pragma once

#include "base/error.h"

#include <string>
#include <vector>

namespace dioptre
{

struct SourceExcerpt {
    int first = 0; // line of the first, from 1
    std::vector<std::string> lines;
};

struct FaultPlace {
    Complaint complaint;
    SourceExcerpt excerpt; // empty where there is no text to show
};

struct Fault {
    std::string text; // as on the terminal
    std::vector<FaultPlace> places;
};

// Reads the lines around each place from its file as it is now.
Fault faultOf(const Error& error);

} // namespace dioptre
