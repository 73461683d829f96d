#include "command/stability.h"

#include "gl/context.h"
#include "stability/case_rows.h"
#include "stability/value_rows.h"
#include "stability/variant.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace dioptre
{
namespace
{

std::string caseHelp()
{
    std::string text = "cases of the table, all by default:";
    for (const CaseRow& row : caseRows())
        text += fmt::format("\n  {} - {}", row.name, row.about);
    for (const ValueRow& row : valueRows())
        text += fmt::format("\n  {} - {}", row.name, row.about);
    return text;
}

} // namespace

void addStability(CLI::App& app, StabilityOptions& options)
{
    auto* command =
        app.add_subcommand("stability", "hold the device's kernels against an oracle in quad precision");
    auto* cases = command->add_option("cases", options.cases, caseHelp())->type_name("CASE");
    command->add_option("--backend", options.backend, "which OpenGL")
        ->check(CLI::IsMember(backendNames()))
        ->capture_default_str();
    auto* seed = command->add_option("--seed", options.seed, "of the random rays")->capture_default_str();
    auto* rays = command->add_option("--rays", options.rays, "of each case; a full run has 200000")
                     ->check(CLI::Range(1, 10'000'000))
                     ->capture_default_str();
    auto* csv =
        command->add_option("--csv", options.csv, "write the table to a file, too")->type_name("FILE");
    auto* plot =
        command->add_option("--plot", options.plot, "draw error against scale, a line a variant, as SVG")
            ->type_name("FILE.svg");
    auto* json = command->add_flag("--json", options.json, "print the table as JSON");
    auto* input =
        command
            ->add_option("--input", options.input,
                         "run the rays of a CSV file instead: case,id,prim,p0..p8,ox,oy,oz,dx,dy,dz,tmin,"
                         "spawn")
            ->type_name("FILE.csv");
    for (auto* option : {cases, seed, rays, csv, plot, json})
        input->excludes(option);
    command
        ->add_option("--output", options.output,
                     "where what they hit goes: case,id,hit,t,px,py,pz,nx,ny,nz; standard output by default")
        ->needs(input)
        ->type_name("FILE.csv");
    std::vector<std::string> variants{"auto"};
    for (const VariantName& variant : variantNames)
        variants.emplace_back(variant.name);
    command
        ->add_option("--variant", options.variant,
                     "which kernels they meet: each ray's strictest, or one for all")
        ->needs(input)
        ->check(CLI::IsMember(variants))
        ->default_str("auto");
}

} // namespace dioptre
