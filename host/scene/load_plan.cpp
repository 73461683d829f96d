#include "scene/sections.h"

#include "scene/table_reader.h"

namespace dioptre
{

PlanChoices readPlan(const Table& document)
{
    PlanChoices plan;
    const Value* section = find(document, "plan");
    if (!section)
        return plan;
    const TableReader reader(
        *section, "[plan]",
        {"force", "values", "lookup", "within", "pictures", "tiles", "arctangent", "pool", "kernels"});
    using Force = PlanChoices::Force;
    using Values = PlanChoices::Values;
    using Lookup = PlanChoices::Lookup;
    reader.choice<Force>("force", plan.force, {{"none", Force::none}, {"all", Force::all}});
    reader.choice<Values>(
        "values", plan.values,
        {{"auto", Values::automatic}, {"shared", Values::shared}, {"uniforms", Values::uniforms}});
    reader.choice<Lookup>(
        "lookup", plan.lookup,
        {{"auto", Lookup::automatic}, {"selects", Lookup::selects}, {"table", Lookup::table}});
    using Within = PlanChoices::Within;
    reader.choice<Within>("within", plan.within, {{"auto", Within::automatic}, {"always", Within::always}});
    using Pictures = PlanChoices::Pictures;
    reader.choice<Pictures>("pictures", plan.pictures,
                            {{"auto", Pictures::automatic}, {"apart", Pictures::apart}});
    using Tiles = PlanChoices::Tiles;
    reader.choice<Tiles>("tiles", plan.tiles,
                         {{"auto", Tiles::automatic}, {"on", Tiles::on}, {"off", Tiles::off}});
    using Arctangent = PlanChoices::Arctangent;
    reader.choice<Arctangent>("arctangent", plan.arctangent,
                              {{"auto", Arctangent::automatic}, {"built-in", Arctangent::builtIn}});
    using Pool = PlanChoices::Pool;
    reader.choice<Pool>("pool", plan.pool, {{"auto", Pool::automatic}, {"always", Pool::always}});
    using Kernels = PlanChoices::Kernels;
    reader.choice<Kernels>("kernels", plan.kernels,
                           {{"auto", Kernels::automatic}, {"plain", Kernels::plain}});
    return plan;
}

} // namespace dioptre
