#include "scene/sections.h"

#include "scene/table_reader.h"

namespace dioptre
{

Display readOutput(const Table& document)
{
    Display output;
    const Value* section = find(document, "output");
    if (!section)
        return output;
    const TableReader reader(*section, "[output]", {"exposure", "curve", "gamma"});
    reader.number("exposure", output.exposure, {-100.0, 100.0, false, "a number of stops from -100 to 100"});
    reader.choice<ToneCurve>("curve", output.curve, toneCurves);
    const Value* gamma = reader.find("gamma");
    const auto* word = gamma ? std::get_if<std::string>(&gamma->data) : nullptr;
    if (gamma && !(word && *word == "srgb"))
        output.gamma = numberFrom(*gamma, "gamma", {0.1, 10.0, false, "\"srgb\" or a number from 0.1 to 10"});
    return output;
}

} // namespace dioptre
