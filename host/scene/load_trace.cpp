#include "scene/sections.h"

#include "scene/table_reader.h"

namespace dioptre
{

Trace readTrace(const Table& document)
{
    Trace trace;
    const Value* section = find(document, "trace");
    if (!section)
        return trace;
    const TableReader reader(*section, "[trace]",
                             {"budget", "depth", "cut_off", "order", "form", "light_type"});
    reader.integer("budget", trace.budget, 1, 4096);
    reader.integer("depth", trace.depth, 0, std::numeric_limits<int>::max());
    reader.number("cut_off", trace.cutOff, zeroOrMore);
    reader.choice<TreeOrder>("order", trace.order, treeOrders);
    reader.choice<SceneForm>("form", trace.form, sceneForms);
    std::optional<int> lightType;
    reader.integer("light_type", lightType, 0, 2);
    trace.lightType = static_cast<LightType>(lightType.value_or(static_cast<int>(trace.lightType)));
    return trace;
}

} // namespace dioptre
