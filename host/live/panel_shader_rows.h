// The rows of a plain shader: its annotated uniforms.
#pragma once

#include "live/panel_row.h"
#include "render/annotation.h"
#include "render/plain_uniforms.h"

namespace dioptre
{

// Of those that the program reads, `active`, and that neither the host feeds nor --set, `given`, has fixed.
// `sliders`: where they stand by now.
std::vector<PanelRow> shaderRows(const std::vector<Annotation>& annotations,
                                 const std::vector<std::string>& active, const PlainValues& given,
                                 const std::map<std::string, std::vector<double>>& sliders);

} // namespace dioptre
