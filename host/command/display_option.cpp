#include "command/display_option.h"

#include "scene/choices.h"

namespace dioptre
{

Display displayAsked(const Display& usual, const std::optional<double>& exposure, const std::string& curve)
{
    Display display = usual;
    display.exposure = exposure.value_or(usual.exposure);
    for (const auto& row : toneCurves)
        if (curve == row.name)
            display.curve = row.choice;
    return display;
}

} // namespace dioptre
